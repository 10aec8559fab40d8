#pragma once
#include <string>

namespace perinox::deck {

/// The kind of mesh or geometry that a file holds, by its first bytes or, where it is no table, by its name: "an Exodus
/// mesh". It is "" for any other file.
std::string mesh_format(const std::string& path);

}  // namespace perinox::deck
