#pragma once
/// Decks written in tests.
#include <string>
#include <vector>

#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::test {

inline deck::Deck deck_of(const std::string& yaml, const std::vector<std::string>& overrides = {}) {
  return deck::read_text(yaml, "test.yaml", materials::full_schema(), overrides);
}

}  // namespace perinox::test
