/// What the load stepper does between an equilibrium and the next load where bonds can break.
#include <fmt/format.h>

#include <algorithm>

#include "perinox/solve/load_stepper.hpp"
#include "perinox/solve/loose_pieces.hpp"

namespace perinox::solve {

std::string LoadStepper::break_bonds(Observer& observer, NewtonResult& total) {
  const Communicator& ranks = scene_.body().communicator;
  const auto most = static_cast<long long>(deck_.fracture.pass_share * static_cast<double>(breaking_->bonds()));
  passes_ = 0;
  for (int pass = 1;; ++pass) {
    const BondBreaking::Result found = breaking_->break_worst(committed_, most);
    if (found.broken == 0) return "";
    const double t = committed_.t();
    observer.bonds_broken({step_, t, pass, found.critical, found.broken, found.worst});
    passes_ = pass;

    const bool loose = let_loose_go(observer);
    mechanics::Trial trial;
    std::vector<double> force(scene_.owned_unknowns());
    mechanics::internal_force(scene_, committed_, committed_.displacement().data(), trial, force.data());
    const double after = ranks.sum(trial.stored);
    energies_.released += energies_.stored - after;
    energies_.stored = after;
    force_ = force;
    newton_.bonds_changed(loose);
    if (pass > deck_.fracture.max_passes)
      return fmt::format("bonds still break after {} passes at t = {:.6g}", deck_.fracture.max_passes, t);

    std::vector<double> guess(committed_.displacement().begin(),
                              committed_.displacement().begin() + static_cast<std::ptrdiff_t>(force.size()));
    const NewtonResult result = newton_.solve(committed_, t, step_, guess, observer, trial, force);
    total.newton_iterations += result.newton_iterations;
    total.linear_iterations += result.linear_iterations;
    if (!result.converged)
      return fmt::format("no equilibrium at t = {:.6g} once {} bonds have broken: {}", t, breaking_->broken(),
                         result.reason);
    if (converged_) converged_(committed_, trial);
    const Energies before = energies_;
    commit(std::move(trial), std::move(force));
    // Neither kinetic energy nor damping is in the model: what the fall has taken is gone.
    energies_.relaxed += before.stored - energies_.stored + before.dissipated - energies_.dissipated +
                         energies_.external_work - before.external_work;
  }
}

bool LoadStepper::let_loose_go(Observer& observer) {
  const LoosePieces found = find_loose(scene_, boundary_);
  breaking_->count_also(found.broken);
  for (const std::string& sentence : found.sentences) observer.note(sentence);
  if (!scene_.body().communicator.any(std::any_of(found.loose.begin(), found.loose.end(), [](char c) { return c; })))
    return false;
  boundary_.let_go(found.loose);
  return true;
}

}  // namespace perinox::solve
