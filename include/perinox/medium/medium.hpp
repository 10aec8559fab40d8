#pragma once
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/core/saved_state.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/medium/displacement.hpp"
#include "perinox/medium/model.hpp"
#include "perinox/medium/tangent.hpp"

namespace perinox::medium {

/// What every medium knows of the state that it was evaluated at last. Energies are those of this rank's particles.
struct Trial {
  double t = 0;                       ///< load parameter
  std::vector<double> displacement;   ///< [at least owned * dimension]
  std::uint64_t version = 0;          ///< of the displacement; 0: it has no number
  std::vector<double> stored_energy;  ///< [owned] energy a volume
  double stored = 0;                  ///< energy
  double dissipated = 0;              ///< energy dissipated in the step

  /// The displacement with its number, if it has one.
  At at() const { return version == 0 ? At(displacement.data()) : At(displacement.data(), version); }
};

/// A model with its state: the committed one, which is that of the last converged step, and the one under trial, which
/// the last evaluate() has left. Everything that solves for equilibrium is written against this interface. Members are
/// collective where nothing else is said.
class Medium {
 public:
  virtual ~Medium() = default;
  /// Not collective.
  virtual const Model& model() const = 0;

  /// The committed state: load parameter, displacement [at least owned * dimension], and the same with its number. Not
  /// collective.
  virtual double t() const = 0;
  virtual const std::vector<double>& displacement() const = 0;
  virtual At at() const = 0;

  /// Internal force [owned * dimension] at a displacement, as seen from the committed state. Leaves the state under
  /// trial. Trial::version is that of the displacement.
  virtual void evaluate(double t, const At& at, double* force) = 0;
  /// Not collective. Worthless before the first evaluate() and after commit().
  virtual const Trial& trial() const = 0;
  /// Names the first of this rank's particles whose force is not finite, in a sentence; "" if all are. Not collective.
  virtual std::string first_not_finite(const double* force) const = 0;

  /// The state under trial becomes the committed one. Returns this rank's share of the work that the internal force has
  /// taken up beyond that along the chord of the step, -(f_before + f_after)/2 . du, where `followed` says that
  /// equilibrium was kept on the way; else 0.
  virtual double commit(bool followed) = 0;

  /// form: as the deck has it. Throws std::logic_error for one that the medium does not have.
  virtual std::unique_ptr<Tangent> make_tangent(deck::TangentForm form) = 0;
  /// prescribed: [local * dimension], ghosts up to date.
  virtual std::unique_ptr<SparseTangent> make_sparse_tangent(deck::TangentForm /*form*/,
                                                             const std::vector<char>& /*prescribed*/) {
    throw std::logic_error("this medium has no sparse tangent");
  }

  /// Fields of the committed state besides displacement and forces, valid until the next call. written: those that cost
  /// something are brought up to date too.
  virtual std::vector<Field> fields(bool written) = 0;
  /// True if owned particle i has flowed in the committed state that fields() was called for last. Not collective.
  virtual bool has_flowed(LocalIndex /*i*/) const { return false; }

  /// The committed state on its way to a checkpoint and back. save_fields() has what fields() shows and no step needs:
  /// it is called also where the state itself is with somebody else.
  virtual void save(StateWriter& writer) const = 0;
  virtual void save_fields(StateWriter& /*writer*/) const {}
  virtual void restore(StateReader& reader) = 0;
};

/// The owned unknowns of the committed displacement: [owned * dimension].
inline std::vector<double> owned_displacement(const Medium& medium) {
  const auto begin = medium.displacement().begin();
  return {begin, begin + static_cast<std::ptrdiff_t>(medium.model().owned_unknowns())};
}

}  // namespace perinox::medium
