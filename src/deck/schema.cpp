#include "perinox/deck/schema.hpp"

#include <stdexcept>

#include "declare.hpp"

namespace perinox::deck {
namespace {

/// Completes choices: one that is declared by its keys alone has one alternative for each of them.
void complete_choices(Key& key) {
  if (key.type == Type::choice && key.alternatives.empty() && key.reference.empty()) {
    for (const Key& inner : key.keys) key.alternatives.push_back({inner.name});
  }
  for (Key& inner : key.keys) complete_choices(inner);
  for (Key& inner : key.element) complete_choices(inner);
}

}  // namespace

Schema::Schema(std::vector<ModelDeclaration> models) : models_(std::move(models)), fields_(declare_fields(models_)) {
  root_ = declare_deck(models_, fields_);
  definitions_.emplace("shape", declare_shape());
  for (ModelDeclaration& declaration : models_) {
    for (Key& key : declaration.keys) complete_choices(key);
  }
}

const Key& Schema::definition(const std::string& name) const {
  const auto found = definitions_.find(name);
  if (found == definitions_.end()) throw std::logic_error("the schema has no definition " + name);
  return found->second;
}

const FieldDeclaration* Schema::field(const std::string& name) const {
  for (const FieldDeclaration& candidate : fields_) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

const ModelDeclaration* Schema::model(const std::string& name) const {
  for (const ModelDeclaration& candidate : models_) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

}  // namespace perinox::deck
