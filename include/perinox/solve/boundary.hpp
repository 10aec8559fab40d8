#pragma once
#include <optional>
#include <string>
#include <vector>

#include "perinox/body/exposed_faces.hpp"
#include "perinox/body/field_table.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::solve {

/// What the deck's `boundary` asks of this rank's particles: which unknowns are prescribed, their values, and the
/// external forces, at any load parameter t.
class Boundary {
 public:
  /// Collective. Throws InputError: a formula that is not a finite number at some particle at the first or the last t,
  /// a table that does not fit, a body or a piece of one that can move as a whole (rigid_modes.hpp).
  Boundary(const deck::Deck& deck, const mechanics::Scene& scene);

  /// [local * dimension], ghosts included: 1 where the displacement is prescribed.
  const std::vector<char>& prescribed() const { return prescribed_; }
  /// Prescribed unknowns and free unknowns over all ranks.
  long long prescribed_count() const { return prescribed_count_; }
  long long free_count() const { return free_count_; }

  /// Takes particles out of the unknowns, for good: they stay where they are whatever acts on them. loose: [owned].
  /// Collective.
  void let_go(const std::vector<char>& loose);
  /// [owned]; empty: none is loose.
  const std::vector<char>& loose() const { return loose_; }

  /// Writes the prescribed values at t into displacement [owned * dimension]; leaves free unknowns alone. Where two
  /// entries prescribe one unknown the later one wins..
  void impose(double t, double* displacement) const;
  /// External forces at t: [owned * dimension], force. A total force is spread over its set by volume; tractions and
  /// pressures act on the reference surface and do not turn with it.
  void external_force(double t, double* force) const;
  /// One sentence for each unknown prescribed twice, at most one per pair of entries; for the log.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Entry {
    const deck::Load* load;
    const std::vector<LocalIndex>* set;
    std::optional<body::FieldTable> table;
    double set_volume = 0;
    std::vector<body::FaceShare> faces{};  ///< traction and pressure
  };
  void add_surface_force(const Entry& entry, double t, double* force) const;
  void check_finite(double t) const;
  double value(const Entry& entry, int component, LocalIndex i, double t) const;

  const mechanics::Scene& scene_;
  std::vector<Entry> entries_;
  void count_unknowns();

  std::vector<char> prescribed_, loose_;
  long long prescribed_count_ = 0;
  long long free_count_ = 0;
  std::vector<std::string> remarks_;
};

}  // namespace perinox::solve
