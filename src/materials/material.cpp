#include "perinox/materials/material.hpp"

#include <map>

#include "perinox/deck/read.hpp"

namespace perinox::materials {

namespace {
// The map is inside a function so that it exists before any translation unit registers its model.
std::map<std::string, Model>& registry() {
  static std::map<std::string, Model> models;
  return models;
}
}  // namespace

bool add_model(Model model) {
  const std::string name = model.declaration.name;
  registry().emplace(name, std::move(model));
  return true;
}

deck::Schema full_schema() { return deck::Schema(declarations()); }

std::vector<deck::ModelDeclaration> declarations() {
  std::vector<deck::ModelDeclaration> all;
  for (const auto& [name, model] : registry()) all.push_back(model.declaration);
  return all;
}

std::unique_ptr<Material> make(const deck::Material& material, deck::Dimension dimension) {
  const auto found = registry().find(material.model);
  if (found != registry().end()) return found->second.make(material, dimension);
  std::vector<std::string> names;
  for (const auto& [name, model] : registry()) names.push_back(name);
  deck::refuse(material.location, "there is no material model " + material.model + "; the nearest is " +
                                      deck::nearest(material.model, names));
}

}  // namespace perinox::materials
