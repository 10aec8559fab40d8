#pragma once
#include <limits>
#include <string>
#include <vector>

#include "perinox/deck/location.hpp"

namespace perinox::materials {

/// Yield stress in pure shear tau over plastic shear strain gamma: straight lines between given rows, constant beyond
/// the last one. Stresses, dimensionless strains.
class HardeningCurve {
 public:
  struct Row {
    double strain = 0;
    double stress = 0;
  };
  /// tau = stress + slope gamma for all gamma.
  HardeningCurve(double stress, double slope);
  /// rows: at least one, strains from 0 and rising.
  explicit HardeningCurve(const std::vector<Row>& rows);

  double stress(double strain) const {
    const Line& line = lines_[line_at(strain)];
    return line.stress + line.slope * (strain - line.begin);
  }
  double lowest_slope() const;
  /// Integral of tau from 0 to gamma, energy a volume.
  double work(double strain) const {
    return flow(0, [&](double, double) { return strain; }).work;
  }
  bool perfect() const { return lines_.size() == 1 && lines_[0].slope == 0; }
  std::size_t lines() const { return lines_.size(); }

  /// A return to the curve from gamma, to its exact end.
  struct Flow {
    double strain = 0;  ///< Delta gamma
    double stress = 0;  ///< tau at the end
    double slope = 0;   ///< d tau/d gamma at the end
    double work = 0;    ///< integral of tau over Delta gamma, energy a volume
  };
  /// solve(stress, slope): the one Delta gamma >= 0 at which the material's driving stress, which falls with Delta
  /// gamma faster than the curve, meets the line stress + slope Delta gamma. Asked line by line until the answer lies
  /// on the line that was asked about.
  template <class Solve>
  Flow flow(double strain, const Solve& solve) const {
    Flow result;
    double begun = 0;  // of Delta gamma, where the line begins
    for (std::size_t k = line_at(strain);; ++k) {
      const Line line = lines_[k];
      const double start = line.stress + line.slope * (strain - line.begin);
      const double end = k + 1 < lines_.size() ? lines_[k + 1].begin - strain : std::numeric_limits<double>::infinity();
      const double met = solve(start, line.slope);
      result.strain = met < end ? met : end;
      result.stress = start + line.slope * result.strain;
      result.slope = line.slope;
      result.work += (start + 0.5 * line.slope * (begun + result.strain)) * (result.strain - begun);
      if (met <= end) return result;
      begun = end;
    }
  }

 private:
  struct Line {
    double begin = 0;   ///< gamma
    double stress = 0;  ///< there
    double slope = 0;
  };
  std::size_t line_at(double strain) const { return lines_.size() == 1 ? 0 : search(strain); }
  std::size_t search(double strain) const;
  std::vector<Line> lines_;
};

/// A CSV file with the columns plastic_strain and yield_stress of a tension test (tension) or of pure shear. Throws
/// InputError at the file's line: a first strain that is not 0, strains that do not rise, a stress that is not
/// positive; at asked_at: no file.
HardeningCurve read_hardening_table(const std::string& path, const deck::Location& asked_at, bool tension);

}  // namespace perinox::materials
