#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "perinox/body/exposed_faces.hpp"
#include "perinox/body/field_table.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/medium/model.hpp"

namespace perinox::loads {

/// What the deck's `boundary` asks of this rank's particles: which unknowns are prescribed, their values, and the
/// external forces, at any load parameter t; in an explicit run t is the time.
class Boundary {
 public:
  /// Collective. Throws InputError: a formula that is not a finite number at some particle at the first or the last t,
  /// a table that does not fit, and, but for dynamics: explicit, a body or a piece of one that can move as a whole
  /// (rigid_modes.hpp).
  Boundary(const deck::Deck& deck, const medium::Model& model);

  /// [local * dimension], ghosts included: 1 where the displacement or the velocity is prescribed.
  const std::vector<char>& prescribed() const { return prescribed_; }
  /// Prescribed unknowns and free unknowns over all ranks.
  long long prescribed_count() const { return prescribed_count_; }
  long long free_count() const { return free_count_; }

  /// Takes particles out of the unknowns, for good: they stay where they are whatever acts on them and whatever is
  /// prescribed for them. loose: [owned].
  /// Collective.
  void let_go(const std::vector<char>& loose);
  /// [owned]; empty: none is loose.
  const std::vector<char>& loose() const { return loose_; }

  /// Writes the prescribed values at t into displacement [owned * dimension]; leaves free unknowns alone. Where two
  /// entries prescribe one unknown the later one wins. Unknowns whose velocity is prescribed are not its business.
  void impose(double t, double* displacement) const;
  /// Writes the prescribed velocities at t into velocity [owned * dimension]; leaves all other unknowns alone.
  void impose_velocity(double t, double* velocity) const;
  /// [owned * dimension]: 1 where a velocity is prescribed and no later entry prescribes the displacement; empty: none
  /// is.
  const std::vector<char>& driven_by_velocity() const { return driven_by_velocity_; }
  /// False where no external force acts on any rank; where none changes with t.
  bool has_forces() const { return has_forces_; }
  bool forces_change() const { return forces_change_; }
  /// External forces at t: [owned * dimension], force. A total force is spread over its set by volume; tractions and
  /// pressures act on the reference surface and do not turn with it.
  void external_force(double t, double* force) const;
  /// Names the first load that is infinite or not a number at t, with its line, place and formula; "" if none is.
  /// Collective.
  std::string not_finite(double t) const;
  /// t nearest to `from` at which a load turns back on the way from there to `to`: where an increment of an entry's
  /// component, or of its table, points against the one before. It is looked for at 32 moments of the way and the times
  /// of tables, and then pinned down; what comes and goes between two of them is not seen. as_it_came: also at `from`
  /// itself, where the load has come from the other side. Prescribed velocities are no loads here. Collective.
  std::optional<double> first_reversal(double from, double to, bool as_it_came) const;
  /// For the log: one sentence for each entry that prescribes unknowns of an earlier one too, for each table that is
  /// not a load over all of the run, and for each load that turns back within a load step where some material remembers
  /// its way.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Entry {
    const deck::Load* load;
    const std::vector<LocalIndex>* set;
    std::optional<body::FieldTable> table;
    double set_volume = 0;
    std::vector<body::FaceShare> faces{};  ///< traction and pressure
    /// [set] values of a component whose formula does not use t; empty: to be evaluated
    std::array<std::vector<double>, 3> steady{};
  };
  struct LoadHistory;
  std::vector<LoadHistory> changing_loads() const;
  /// Of load steps that do not see where a load turns back, where some material remembers its way. Collective.
  void remark_on_reversals(const deck::Deck& deck);
  void take_prescribed(std::vector<double>& mark, const std::vector<int>& prescriber);
  void keep_steady_values();
  void count_unknowns();
  void add_surface_force(const Entry& entry, double t, double* force) const;
  std::string first_not_finite(double t) const;
  double value(const Entry& entry, int component, LocalIndex i, double t) const;
  /// Of the k-th particle of the entry's set.
  double value_of(const Entry& entry, int component, std::size_t k, double t) const;

  const medium::Model& model_;
  std::vector<Entry> entries_;
  std::vector<char> prescribed_, loose_;
  std::vector<char> driven_by_velocity_;
  bool has_forces_ = false;
  bool forces_change_ = false;
  long long prescribed_count_ = 0;
  long long free_count_ = 0;
  std::vector<std::string> remarks_;
};

}  // namespace perinox::loads
