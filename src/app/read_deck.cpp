#include "commands.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::app {

deck::Deck read_deck(const Options& options, const Communicator& communicator) {
  deck::Deck result;
  std::string sentence;
  try {
    result = deck::read(options.deck, materials::full_schema(), options.overrides);
  } catch (const InputError& error) {
    sentence = error.what();
  }
  communicator.agree_on_input_error(sentence);
  return result;
}

}  // namespace perinox::app
