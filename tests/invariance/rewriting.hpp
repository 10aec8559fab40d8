#pragma once
/// Writes a deck anew under a transformation. The schema says what each key is and in which unit, so that a key that is
/// added to it later is transformed too, or refused if its unit is unknown.
#include <string>

#include "transformation.hpp"

namespace perinox::invariance {

/// A deck as text, and the folder from which its file names count.
struct DeckText {
  std::string yaml;
  std::string folder;
};

/// The deck under a transformation. Clouds, tables and hardening curves are rewritten too, into files beginning with
/// `prefix`. A transformation that is not along the axes is for decks whose bodies are clouds and whose supports hold
/// all components; the history, which is by components, is then left out. Throws std::logic_error for what it cannot
/// express.
std::string transformed(const DeckText& deck, const Transformation& change, const std::string& prefix);

}  // namespace perinox::invariance
