#include "perinox/app/commands.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::app {

deck::Schema full_schema() { return deck::Schema(materials::declarations()); }

deck::Deck read_deck(const Options& options, const Communicator& communicator) {
  deck::Deck result;
  std::string sentence;
  try {
    result = deck::read(options.deck, full_schema(), options.overrides);
  } catch (const InputError& error) {
    sentence = error.what();
  }
  communicator.agree_on_input_error(sentence);
  return result;
}

}  // namespace perinox::app
