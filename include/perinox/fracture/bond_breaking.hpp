#pragma once
#include <memory>
#include <vector>

#include "perinox/fracture/bond_limits.hpp"
#include "perinox/fracture/bond_screen.hpp"
#include "perinox/fracture/moving_state.hpp"
#include "perinox/mechanics/internal_force.hpp"
#include "perinox/mechanics/state.hpp"
#include "perinox/mechanics/stress.hpp"

namespace perinox::fracture {

class BrokenBonds;
struct LoosePieces;

/// Finds the bonds that have come to their limits and breaks them. Both ranks of a bond between ranks come to the same
/// answer to the last bit, as they see the same numbers in the same order.
class BondBreaking {
 public:
  /// Only for decks that break. evaluation: of the scene, shared with whoever asks for its internal force; null: its
  /// own. Throws InputError. Collective.
  BondBreaking(const deck::Deck& deck, mechanics::Scene& scene,
               std::shared_ptr<mechanics::Evaluation> evaluation = nullptr);

  struct Result {
    long long critical = 0;  ///< bonds at or above their limit
    long long broken = 0;
    double worst = 0;  ///< largest measure over limit of all bonds that can break
  };
  /// Breaks the worst of the critical bonds of a state, `most` of them over all ranks or as many as equal the worst to
  /// `tie`; where `most` is 0 none, but counts them. Collective.
  Result break_worst(const mechanics::Committed& state, long long most);
  /// Breaks all critical bonds of a motion right after a time step of it, and tells the motion. Returns how many over
  /// all ranks. Collective.
  long long break_all(MovingState& motion);

  /// Bonds over all ranks before any broke.
  long long bonds() const { return bonds_; }
  long long broken() const { return broken_; }
  /// Bonds that somebody else has broken: find_loose, or the run that a checkpoint is of.
  void count_also(const LoosePieces& loose);
  void resume(const BrokenBonds& broken);
  /// Where in Scene::broken() each round of breaking began on this rank; the same rounds on all of them.
  const std::vector<std::size_t>& rounds() const { return rounds_; }
  const std::vector<BondLimit>& limits() const { return limits_; }

  /// Measures this near to each other, or to the limit, count as one, so that bonds alike by symmetry break together
  /// and rounding does not choose between them.
  static constexpr double tie = 1e-6;

 private:
  struct Critical {
    double ratio;
    mechanics::BondEnds ends;
  };
  /// Of the bonds looked at on this rank.
  struct Judged {
    double worst = 0;
    std::vector<Critical> critical;
    std::vector<double> counted;  ///< measures of critical bonds whose smaller id is this rank's
  };
  void judge(LocalIndex near, LocalIndex far, double length, double weight, const double* displacement,
             Judged& judged) const;
  Result break_above(const Judged& judged, long long most, const mechanics::PlasticExtension& plastic);
  void find_points(const mechanics::Committed& state);
  /// lower, upper: ends by ascending id.
  double ratio(LocalIndex lower, LocalIndex upper, double length, double weight, const double* displacement) const;
  double energy(LocalIndex lower, LocalIndex upper, double length, double weight, double extension) const;

  mechanics::Scene& scene_;
  std::shared_ptr<mechanics::Evaluation> evaluation_;
  std::vector<BondLimit> limits_;
  std::vector<char> unbreakable_;  ///< [local]
  long long bonds_ = 0, broken_ = 0;
  std::vector<std::size_t> rounds_;
  bool energies_ = false, ductile_ = false;
  std::vector<double> points_;   ///< [local * (2 + mandel_size)] radial, shear and H of the force states
  std::vector<double> failure_;  ///< [local] equivalent plastic strain over the failure strain; -1: no such law
  std::vector<std::size_t> strain_place_;  ///< [materials] of the equivalent plastic strain in the point history
  std::unique_ptr<mechanics::Stress> stress_;
  std::unique_ptr<BondScreen> screen_;  ///< of motions
};

}  // namespace perinox::fracture
