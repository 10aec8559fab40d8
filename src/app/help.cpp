#include <fmt/format.h>

#include "commands.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::app {

int help(const std::string& key, bool page, bool json_schema, const Communicator& communicator) {
  const deck::Schema schema = materials::full_schema();
  const std::string text = page ? schema.reference_page() : json_schema ? schema.json_schema() : schema.help(key);
  if (communicator.is_root()) fmt::print("{}{}", text, !text.empty() && text.back() == '\n' ? "" : "\n");
  return 0;
}

}  // namespace perinox::app
