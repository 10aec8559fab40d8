#include "chebyshev_acceleration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "perinox/linear/lanczos.hpp"

namespace perinox::linear {

namespace {

constexpr int most_products = 15;
constexpr double accuracy = 0.03;
/// The largest Ritz value is from below, the smallest one from above.
constexpr double margin_above = 1.05, margin_below = 0.7;
/// Of the interval at most: beyond it three steps treat the upper eigenvalues no better than a Krylov method would.
constexpr double most_ratio = 64;

}  // namespace

ChebyshevAcceleration::ChebyshevAcceleration(Teuchos::RCP<const tpetra::Map> map, const body::Body& body,
                                             const std::vector<char>& prescribed, const OwnedOperator& k,
                                             const OwnedOperator& m, int steps)
    : OwnedOperator(std::move(map)), body_(body), prescribed_(prescribed), k_(k), m_(m), steps_(steps) {
  if (steps % 2 == 0) throw std::logic_error("Chebyshev's polynomial of even degree is not positive everywhere");
}

void ChebyshevAcceleration::estimate() {
  const auto d = static_cast<std::size_t>(body_.dimension);
  std::vector<double> start(static_cast<std::size_t>(body_.owned) * d);
  for (std::size_t u = 0; u < start.size(); ++u)
    start[u] = prescribed_[u] ? 0 : scatter(body_.id[u / d], static_cast<int>(u % d));
  const auto with = [](const OwnedOperator& by) {
    return [&by](const std::vector<double>& x, std::vector<double>& y) { by.multiply(x.data(), y.data()); };
  };
  const Ritz ritz = largest_eigenvalue(body_.communicator, start, with(k_), with(m_), {most_products, accuracy});
  interval_ = {};
  if (!std::isfinite(ritz.value) || ritz.value == 0) return;
  interval_.highest = margin_above * std::abs(ritz.value);
  interval_.lowest = std::max(margin_below * ritz.least, interval_.highest / most_ratio);
}

void ChebyshevAcceleration::multiply(const double* x, double* y) const {
  if (interval_.highest == 0) return m_.multiply(x, y);
  const std::size_t unknowns = static_cast<std::size_t>(body_.owned) * static_cast<std::size_t>(body_.dimension);
  const double middle = (interval_.highest + interval_.lowest) / 2, half = (interval_.highest - interval_.lowest) / 2;
  left_.assign(x, x + unknowns);
  corrected_.resize(unknowns);
  direction_.resize(unknowns);
  double rho = half / middle;
  for (int step = 0; step < steps_; ++step) {
    m_.multiply(left_.data(), corrected_.data());
    const double next = 1 / (2 * middle / half - rho);
    const double keep = step == 0 ? 0 : next * rho, take = step == 0 ? 1 / middle : 2 * next / half;
    if (step > 0) rho = next;
    for (std::size_t u = 0; u < unknowns; ++u) {
      direction_[u] = keep * direction_[u] + take * corrected_[u];
      y[u] = (step == 0 ? 0 : y[u]) + direction_[u];
    }
    if (step + 1 == steps_) return;
    k_.multiply(y, left_.data());
    for (std::size_t u = 0; u < unknowns; ++u) left_[u] = x[u] - left_[u];
  }
}

}  // namespace perinox::linear
