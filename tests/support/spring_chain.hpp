#pragma once
/// A medium that is no peridynamic one: a straight row of particles, each joined to the next by a spring that flows.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "perinox/medium/medium.hpp"

namespace perinox::test {

/// Spring constants: force a length, and the force at which flow begins.
struct SpringLaw {
  double stiffness = 1000, hardening = 250, yield = 10, across = 500;
};

class SpringModel : public medium::Model {
 public:
  /// body: particles in the order of their ids along x, all on this rank.
  explicit SpringModel(body::Body body) : Model(std::move(body)) {}
  bonds::BondGraph bond_graph() const override {
    return [count = owned()](LocalIndex i, std::vector<LocalIndex>& neighbors) {
      neighbors.clear();
      if (i > 0) neighbors.push_back(i - 1);
      if (i + 1 < count) neighbors.push_back(i + 1);
    };
  }
  double horizon() const override { return 1; }
  bool symmetric() const override { return true; }
  bool small_strain() const override { return true; }
  bool remembers() const override { return true; }
};

/// Spring s joins particles s and s + 1. Along x its force is k (e - p), and its slip p grows where that is more than
/// yield + hardening * p. Across, the springs are linear.
class SpringChain : public medium::Medium {
 public:
  SpringChain(body::Body body, const SpringLaw& law) : model_(std::move(body)), law_(law) {
    displacement_.assign(model_.local_unknowns(), 0.0);
    slip_.assign(springs(), 0.0);
    stored_energy_.assign(static_cast<std::size_t>(model_.owned()), 0.0);
    shown_slip_ = stored_energy_;
    version_ = medium::new_version();
  }

  const SpringModel& model() const override { return model_; }
  double t() const override { return t_; }
  const std::vector<double>& displacement() const override { return displacement_; }
  medium::At at() const override { return {displacement_.data(), version_}; }
  const medium::Trial& trial() const override { return trial_; }
  std::string first_not_finite(const double*) const override { return ""; }

  void evaluate(double t, const medium::At& at, double* force) override {
    trial_ = medium::Trial();
    trial_.t = t;
    trial_.version = at.version;
    trial_.displacement.assign(at.displacement, at.displacement + model_.owned_unknowns());
    trial_.stored_energy.assign(stored_energy_.size(), 0.0);
    trial_slip_ = slip_;
    std::fill(force, force + model_.owned_unknowns(), 0.0);
    for (std::size_t s = 0; s < springs(); ++s) {
      const double e = trial_.displacement[2 * s + 2] - trial_.displacement[2 * s];
      const double shear = trial_.displacement[2 * s + 3] - trial_.displacement[2 * s + 1];
      const double over = law_.stiffness * (e - slip_[s]) - law_.yield - law_.hardening * slip_[s];
      if (over > 0) trial_slip_[s] += over / (law_.stiffness + law_.hardening);
      const double along = law_.stiffness * (e - trial_slip_[s]), grown = trial_slip_[s] - slip_[s];
      const double energy = 0.5 * law_.stiffness * std::pow(e - trial_slip_[s], 2) + 0.5 * law_.across * shear * shear;
      trial_.stored += energy;
      trial_.dissipated += grown * (law_.yield + law_.hardening * (slip_[s] + 0.5 * grown));
      trial_.stored_energy[s] = energy / model_.body().volume[s];
      force[2 * s] += along;
      force[2 * s + 2] -= along;
      force[2 * s + 1] += law_.across * shear;
      force[2 * s + 3] -= law_.across * shear;
    }
  }

  double commit(bool followed) override {
    double beyond = 0;
    for (std::size_t s = 0; followed && s < springs(); ++s) {
      const double before = displacement_[2 * s + 2] - displacement_[2 * s],
                   after = trial_.displacement[2 * s + 2] - trial_.displacement[2 * s];
      const double first = law_.stiffness * (before - slip_[s]), last = law_.stiffness * (after - trial_slip_[s]);
      const double grown = trial_slip_[s] - slip_[s];
      beyond += 0.5 * (last * last - first * first) / law_.stiffness +
                grown * (law_.yield + law_.hardening * (slip_[s] + 0.5 * grown)) -
                0.5 * (first + last) * (after - before);
    }
    t_ = trial_.t;
    std::copy(trial_.displacement.begin(), trial_.displacement.end(), displacement_.begin());
    slip_ = trial_slip_;
    stored_energy_ = trial_.stored_energy;
    version_ = medium::new_version();
    trial_.version = 0;
    return beyond;
  }

  class Tangent : public medium::Tangent {
   public:
    explicit Tangent(const SpringChain& chain) : chain_(chain), along_(chain.springs()) {}
    bool linearise(const medium::At& at) override {
      const SpringLaw& law = chain_.law_;
      for (std::size_t s = 0; s < along_.size(); ++s) {
        const double e = at.displacement[2 * s + 2] - at.displacement[2 * s], slip = chain_.slip_[s];
        const bool flows = law.stiffness * (e - slip) > law.yield + law.hardening * slip;
        along_[s] = flows ? law.stiffness * law.hardening / (law.stiffness + law.hardening) : law.stiffness;
      }
      return true;
    }
    void apply(const double* x, double* y) const override {
      std::fill(y, y + chain_.model_.owned_unknowns(), 0.0);
      for (std::size_t s = 0; s < along_.size(); ++s)
        for (std::size_t c = 0; c < 2; ++c) {
          const double pull = stiffness(s, c) * (x[2 * s + 2 + c] - x[2 * s + c]);
          y[2 * s + c] -= pull;
          y[2 * s + 2 + c] += pull;
        }
    }
    void diagonal_blocks(double* blocks, double) const override {
      std::fill(blocks, blocks + 2 * chain_.model_.owned_unknowns(), 0.0);
      for (std::size_t s = 0; s < along_.size(); ++s)
        for (std::size_t c = 0; c < 2; ++c)
          for (const std::size_t end : {s, s + 1}) blocks[4 * end + 3 * c] += stiffness(s, c);
    }

   private:
    double stiffness(std::size_t s, std::size_t c) const { return c == 0 ? along_[s] : chain_.law_.across; }
    const SpringChain& chain_;
    std::vector<double> along_;
  };
  std::unique_ptr<medium::Tangent> make_tangent(deck::TangentForm) override { return std::make_unique<Tangent>(*this); }

  std::vector<Field> fields(bool) override {
    std::copy(slip_.begin(), slip_.end(), shown_slip_.begin());
    return {{"stored_energy", 1, stored_energy_.data()}, {"equivalent_plastic_strain", 1, shown_slip_.data()}};
  }
  bool has_flowed(LocalIndex i) const override { return shown_slip_[static_cast<std::size_t>(i)] > 0; }

  void save(StateWriter& writer) const override {
    std::vector<double> slip(stored_energy_.size(), 0.0);
    std::copy(slip_.begin(), slip_.end(), slip.begin());
    writer.number("chain/t", t_);
    writer.particles("chain/displacement", displacement_.data(), 2);
    writer.particles("chain/slip", slip.data(), 1);
    writer.particles("chain/stored_energy", stored_energy_.data(), 1);
  }
  void restore(StateReader& reader) override {
    t_ = reader.number("chain/t");
    displacement_ = reader.particles("chain/displacement", 2);
    slip_ = reader.particles("chain/slip", 1);
    slip_.pop_back();
    stored_energy_ = reader.particles("chain/stored_energy", 1);
    version_ = medium::new_version();
  }

 private:
  std::size_t springs() const { return static_cast<std::size_t>(model_.owned()) - 1; }

  SpringModel model_;
  SpringLaw law_;
  double t_ = 0;
  std::vector<double> displacement_, slip_, stored_energy_, trial_slip_, shown_slip_;
  std::uint64_t version_ = 0;
  medium::Trial trial_;
};

}  // namespace perinox::test
