#include "hardening_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/body/csv.hpp"

namespace perinox::materials {

HardeningCurve::HardeningCurve(double stress, double slope) : lines_{{0, stress, slope}} {}

HardeningCurve::HardeningCurve(const std::vector<Row>& rows) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool last = k + 1 == rows.size();
    lines_.push_back({rows[k].strain, rows[k].stress,
                      last ? 0 : (rows[k + 1].stress - rows[k].stress) / (rows[k + 1].strain - rows[k].strain)});
  }
}

std::size_t HardeningCurve::search(double strain) const {
  const auto after =
      std::upper_bound(lines_.begin(), lines_.end(), strain, [](double s, const Line& line) { return s < line.begin; });
  return after == lines_.begin() ? 0 : static_cast<std::size_t>(after - lines_.begin()) - 1;
}

double HardeningCurve::lowest_slope() const {
  return std::min_element(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) { return a.slope < b.slope; })
      ->slope;
}

HardeningCurve read_hardening_table(const std::string& path, const deck::Location& asked_at, bool tension) {
  const body::CsvTable table(path, asked_at, {"a hardening table", {"plastic_strain", "yield_stress"}, {}});
  const std::size_t strain = table.column("plastic_strain"), stress = table.column("yield_stress");
  // A tension test is converted by gamma = sqrt(3) eps and tau = sigma/sqrt(3) (Eq. 56).
  const double root = tension ? std::sqrt(3.0) : 1;
  std::vector<HardeningCurve::Row> rows;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double at = table.value(k, strain), value = table.value(k, stress);
    if (k == 0 && at != 0)
      deck::refuse(
          table.where(k, strain),
          fmt::format("a hardening table begins at plastic strain 0, but this one at {:g}; add the row of first "
                      "yield",
                      at));
    if (k > 0 && at <= table.value(k - 1, strain))
      deck::refuse(table.where(k, strain),
                   fmt::format("plastic_strain is {:g} after {:g}; sort the rows so that it rises from row to row", at,
                               table.value(k - 1, strain)));
    if (value <= 0)
      deck::refuse(table.where(k, stress), fmt::format("yield_stress is {:g} but must be greater than 0", value));
    rows.push_back({root * at, value / root});
  }
  return HardeningCurve(rows);
}

}  // namespace perinox::materials
