#include "perinox/materials/family.hpp"

#include <stdexcept>

namespace perinox::materials {

Mandel force_of_fit(const bonds::Moment& moment, const StrainFit& fit, const PointState& point) {
  Mandel h = volumetric(moment);
  for (std::size_t k = 0; k < h.size(); ++k) h[k] = point.pressure * h[k] + (point.shear - point.back) * fit.slope[k];
  if (point.back != 0)
    for (std::size_t k = 0; k < h.size(); ++k) h[k] += point.back * fit.total_slope[k];
  return h;
}

Mandel slope_of_fit(const bonds::Moment& moment, const StrainFit& fit, const PointModulus& point) {
  if (point.flow_pressure == 0) return fit.slope;
  Mandel slope = volumetric(moment);
  for (std::size_t k = 0; k < slope.size(); ++k) slope[k] = point.flow_pressure * slope[k] + fit.slope[k];
  return slope;
}

void ModulusState::reset(int count) {
  count_ = count;
  rank_ = 0;
  diagonal_.resize(static_cast<std::size_t>(count));
}

void ModulusState::add_radial(double coefficient) {
  if (rank_ == max_rank) throw std::logic_error("a modulus state has more rank-one terms than max_rank");
  terms_[static_cast<std::size_t>(rank_++)] = {coefficient, true, nullptr, nullptr};
}

double* ModulusState::add_symmetric(double coefficient) {
  if (rank_ == max_rank) throw std::logic_error("a modulus state has more rank-one terms than max_rank");
  auto& values = storage_[static_cast<std::size_t>(rank_)];
  values.resize(static_cast<std::size_t>(count_));
  terms_[static_cast<std::size_t>(rank_++)] = {coefficient, false, values.data(), values.data()};
  return values.data();
}

}  // namespace perinox::materials
