#include "perinox/app/commands.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::app {

deck::Schema full_schema() { return deck::Schema(materials::declarations()); }

namespace {

/// What is wrong between keys that are right one by one: said before any particle is made.
void refuse_unfit_solver(const deck::Deck& deck) {
  using deck::Preconditioner;
  const Preconditioner kind = deck.solver.linear.preconditioner;
  if (deck.solver.tangent == deck::TangentKind::assembled || kind == Preconditioner::automatic ||
      kind == Preconditioner::none || kind == Preconditioner::block_jacobi)
    return;
  const deck::Value& word = deck.resolved.at("solver").at("linear").at("preconditioner");
  deck::refuse(word.location(), "the preconditioner " + word.text() +
                                    " needs the assembled matrix; write tangent: assembled in solver, or take "
                                    "block-jacobi");
}

}  // namespace

deck::Deck read_deck(const Options& options, const Communicator& communicator) {
  deck::Deck result;
  std::string sentence;
  try {
    result = deck::read(options.deck, full_schema(), options.overrides);
    refuse_unfit_solver(result);
  } catch (const InputError& error) {
    sentence = error.what();
  }
  communicator.agree_on_input_error(sentence);
  return result;
}

}  // namespace perinox::app
