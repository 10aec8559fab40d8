#pragma once
/// Broken bonds as a checkpoint holds them. They need particles, and no scene.
#include <array>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/moment.hpp"
#include "perinox/core/saved_state.hpp"

namespace perinox::fracture {

constexpr const char* broken_name = "fracture/broken";
constexpr const char* broken_extension_name = "fracture/broken_extension";
/// Numbers of a bonds::BrokenExtension.
constexpr int broken_extension_size = 13;

/// lower id, upper id, round
using BrokenEntry = std::array<long long, 3>;

/// All entries of a checkpoint, on every rank, sorted by ids: ids are those of particles, the upper one the larger, no
/// bond is there twice, and there are no more rounds than bonds. Throws InputError. Collective.
std::vector<BrokenEntry> read_broken_table(const body::Body& body, const StateReader& reader);

/// [owned], or empty where no broken bond had flowed. Throws InputError. Collective.
std::vector<bonds::BrokenExtension> read_broken_extension(const StateReader& reader);

}  // namespace perinox::fracture
