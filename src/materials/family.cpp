#include "perinox/materials/family.hpp"

#include <stdexcept>

namespace perinox::materials {

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
