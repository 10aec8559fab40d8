#include "../targets.hpp"
#include "accepted.hpp"
#include "body/lattice.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::fuzz {

bool deck(const std::string& input) {
  static const deck::Schema schema(materials::declarations());
  deck::Deck first;
  const bool good = accepted([&] {
    first = deck::read_text(input, "fuzz.yaml", schema);
    for (const deck::Material& material : first.materials) materials::make(material, first.dimension);
    for (const deck::BodyPart& part : first.body)
      if (!std::holds_alternative<deck::CloudFile>(part.shape.form))
        body::Lattice(part, deck::unknowns(first.dimension));
  });
  if (!good) return false;
  // What is written beside the results must be the same deck.
  const std::string resolved = deck::write_resolved(first);
  deck::Deck second;
  demand(accepted([&] { second = deck::read_text(resolved, "resolved.yaml", schema); }),
         "the resolved deck is not a deck");
  demand(deck::write_resolved(second) == resolved, "the resolved deck does not read back as itself");
  return true;
}

}  // namespace perinox::fuzz
