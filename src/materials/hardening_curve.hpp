#pragma once
#include <limits>
#include <string>
#include <vector>

#include "perinox/deck/location.hpp"

namespace perinox::materials {

/// Yield stress in pure shear tau over plastic shear strain gamma. It is piecewise linear between given rows and
/// constant beyond the last one. tau is a stress, gamma is dimensionless.
class HardeningCurve {
 public:
  struct Row {
    double strain = 0;
    double stress = 0;
  };
  /// The straight line tau = stress + slope gamma for all gamma.
  HardeningCurve(double stress, double slope);
  /// rows: at least one, with strains that begin at 0 and rise.
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

  /// The result of a return to the curve from gamma.
  struct Flow {
    double strain = 0;  ///< Delta gamma
    double stress = 0;  ///< tau at the end
    double slope = 0;   ///< d tau/d gamma at the end
    double work = 0;    ///< integral of tau over Delta gamma, energy a volume
  };
  /// Returns to the curve from plastic shear strain `strain`. solve(stress, slope) gives the one Delta gamma >= 0 at
  /// which the material's driving stress, which falls with Delta gamma faster than the curve, meets the line stress +
  /// slope Delta gamma. It is called line by line until the answer lies on the line of the call, so the result is
  /// exact.
  template <class Solve>
  Flow flow(double strain, const Solve& solve) const {
    Flow result;
    double begun = 0;  // Delta gamma where the line begins
    for (std::size_t k = line_at(strain);; ++k) {
      const Line line = lines_[k];
      const double start = line.stress + line.slope * (strain - line.begin);
      const double end = k + 1 < lines_.size() ? lines_[k + 1].begin - strain : std::numeric_limits<double>::infinity();
      const double met = solve(start, line.slope);
      result.strain = met > end ? end : met;
      result.stress = start + line.slope * result.strain;
      result.slope = line.slope;
      result.work += (start + 0.5 * line.slope * (begun + result.strain)) * (result.strain - begun);
      if (!(met > end)) return result;  // also what is not a number, for whoever asks to see
      begun = end;
    }
  }

 private:
  struct Line {
    double begin = 0;   ///< gamma at which the line begins
    double stress = 0;  ///< tau there
    double slope = 0;
  };
  std::size_t line_at(double strain) const { return lines_.size() == 1 ? 0 : search(strain); }
  std::size_t search(double strain) const;
  std::vector<Line> lines_;
};

/// Reads a hardening curve from a CSV file with the columns plastic_strain and yield_stress of a tension test (tension)
/// or of pure shear. Throws InputError at the file's line if the first strain is not 0, if strains do not rise or if a
/// stress is not positive, and at asked_at if there is no file.
HardeningCurve read_hardening_table(const std::string& path, const deck::Location& asked_at, bool tension);

}  // namespace perinox::materials
