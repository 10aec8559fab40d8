#include "perinox/equilibrium/path_constraint.hpp"

#include <cmath>

namespace perinox::equilibrium {

double PathNorm::product(const PathPoint& a, const PathPoint& b) const {
  const std::vector<double>&of_a = a.displacement.values(), &of_b = b.displacement.values();
  double dot = 0;
  for (std::size_t u = 0; u < of_a.size(); ++u) dot += of_a[u] * of_b[u];
  return ranks->sum(dot) / (length * length);
}

double PathNorm::of(const PathPoint& a) const { return std::sqrt(product(a, a)); }

PathPoint FixedArc::step(const PathPoint& at) const {
  PathPoint step = at;
  std::vector<double>& change = step.displacement.change();
  for (std::size_t u = 0; u < change.size(); ++u) change[u] -= origin_.displacement.values()[u];
  step.t -= origin_.t;
  return step;
}

double FixedArc::value(const PathPoint& at) const {
  const PathPoint increment = step(at);
  return norm_.product(increment, increment) / (arc_ * arc_) - 1;
}

double FixedArc::slope(const PathPoint& at, const PathPoint& direction) const {
  return 2 * norm_.product(step(at), direction) / (arc_ * arc_);
}

FixedMean::FixedMean(const Communicator& ranks, const std::vector<LocalIndex>& set, const std::vector<double>& volume,
                     int dimension, int component, double target)
    : ranks_(ranks),
      set_(set),
      volume_(volume),
      dimension_(static_cast<std::size_t>(dimension)),
      component_(static_cast<std::size_t>(component)),
      target_(target) {
  double own = 0;
  for (const LocalIndex i : set) own += volume[static_cast<std::size_t>(i)];
  whole_ = ranks.sum(own);
}

double FixedMean::mean(const std::vector<double>& displacement) const {
  double sum = 0;
  for (const LocalIndex i : set_)
    sum += volume_[static_cast<std::size_t>(i)] * displacement[static_cast<std::size_t>(i) * dimension_ + component_];
  return ranks_.sum(sum) / whole_;
}

}  // namespace perinox::equilibrium
