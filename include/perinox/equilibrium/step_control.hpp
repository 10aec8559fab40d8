#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/equilibrium/newton.hpp"

namespace perinox::equilibrium {

/// Where the next step goes, how long it is, and when the run is over. Collective.
class StepControl {
 public:
  virtual ~StepControl() = default;
  virtual bool finished() const = 0;
  /// Solves the next step from the committed state; arguments as in Newton::solve.
  virtual NewtonResult attempt(int step, Observer& observer, std::vector<double>& force) = 0;
  /// t that the last attempt went to.
  virtual double tried() const = 0;
  /// The attempt was good; the medium's state under trial is about to be committed.
  virtual void accept() = 0;
  /// The committed state has become another one since the last accept(), at `t`: bonds have broken, or the run has gone
  /// on in time. The last increment says nothing.
  virtual void jumped(double /*t*/) {}
  /// The attempt failed. False if the step may not be made shorter.
  virtual bool cut() = 0;
  /// Undoes the cuts since the last accept(): whoever goes on from here has other settings and may pass in one step.
  virtual void forget_cuts() {}
  /// What a finished run has not come to, a sentence; "": nothing.
  virtual std::string unreached() const { return {}; }
  /// Share of the run that is done, for an estimate of the time left: above 0, at most 1.
  virtual double share() const = 0;
  /// What the next attempt goes on from, and the way back, the committed state being that of then. Throws
  /// std::logic_error where it is not there yet: deck::not_in_checkpoints. Collective.
  virtual void save(StateWriter&) const { throw std::logic_error("this step control keeps nothing for a restart"); }
  virtual void restore(StateReader&) { throw std::logic_error("this step control takes nothing from a checkpoint"); }
};

/// steps.control: load. Whole steps end at t = end * k/count exactly; a cut step never passes such a t.
class LoadSteps : public StepControl {
 public:
  LoadSteps(const deck::Deck& deck, medium::Medium& medium, const loads::Boundary& boundary, Newton& newton);

  bool finished() const override { return done_ >= steps_.count; }
  NewtonResult attempt(int step, Observer& observer, std::vector<double>& force) override;
  double tried() const override { return tried_; }
  void accept() override;
  void jumped(double t) override;
  bool cut() override;
  void forget_cuts() override;
  double share() const override { return tried_ / steps_.end; }
  void save(StateWriter& writer) const override;
  void restore(StateReader& reader) override;

 private:
  double whole_end() const { return steps_.end * (done_ + 1) / steps_.count; }
  double next(double t) const;
  std::vector<double> first_guess(double t) const;

  const deck::Steps& steps_;
  medium::Medium& medium_;
  const loads::Boundary& boundary_;
  Newton& newton_;
  double size_;
  int done_ = 0;
  int cuts_ = 0;
  int accepted_cuts_ = 0;  ///< after the last accept()
  double tried_ = 0;
  // The committed step before, for extrapolation.
  double previous_t_ = 0;
  std::vector<double> previous_displacement_;
  bool has_previous_ = false;
};

}  // namespace perinox::equilibrium
