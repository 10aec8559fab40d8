#include "perinox/materials/strain_fit.hpp"

#include <Eigen/Core>

namespace perinox::materials {

namespace {

template <int n>
using Square = Eigen::Matrix<double, n, n, Eigen::RowMajor>;
template <int n>
using Column = Eigen::Matrix<double, n, 1>;

template <int n>
constexpr int dimension_of = n == 6 ? 3 : 2;

template <int n>
Column<n> identity() {
  Column<n> one = Column<n>::Zero();
  one.template head<dimension_of<n>>().setOnes();
  return one;
}
/// A tensor without its trace.
template <int n>
Column<n> deviator(const Column<n>& v) {
  return v - identity<n>() * (identity<n>().dot(v) / dimension_of<n>);
}
template <int n>
Eigen::Map<const Column<n>> view(const Mandel& v) {
  return Eigen::Map<const Column<n>>(v.data());
}
template <int n>
Eigen::Map<const Square<n>> inverse_of(const bonds::Moment& moment) {
  return Eigen::Map<const Square<n>>(moment.inverse.data());
}
/// The factor 2m/(d(d+2)), which is 2 mu/alpha.
double shear_weight(const bonds::Moment& moment) {
  return 2 * moment.weighted_volume() / (moment.dimension * (moment.dimension + 2));
}

template <int n>
StrainFit fit_of(const bonds::Moment& moment, const Mandel& extension, const Mandel& plastic, double square,
                 double shift) {
  const auto inverse = inverse_of<n>(moment);
  const Column<n> one = identity<n>(), sums = view<n>(extension);
  StrainFit result;
  result.dilatation = one.dot(inverse * sums);
  // The sums are taken about the shift, so that little cancels.
  const Column<n> away = sums - view<n>(plastic) - shift * view<n>(moment.second);
  const Column<n> strain = inverse * away;
  const Column<n> shear = deviator<n>(strain);
  const double weight = shear_weight(moment), rest = square - strain.dot(away);
  result.square = weight * shear.squaredNorm() + (rest > 0 ? rest : 0);
  Eigen::Map<Column<n>>(result.slope.data()) = weight * (inverse * shear) - strain - shift * one;
  return result;
}

template <int n>
std::array<double, 36> modulus_of(const bonds::Moment& moment, double bulk, double shear) {
  const auto inverse = inverse_of<n>(moment);
  const Column<n> pressure = inverse * identity<n>();
  const Square<n> dev = Square<n>::Identity() - identity<n>() * identity<n>().transpose() / dimension_of<n>;
  std::array<double, 36> all{};
  Eigen::Map<Square<n>> result(all.data());
  result = bulk * pressure * pressure.transpose() + shear * (shear_weight(moment) * inverse * dev * inverse - inverse);
  return all;
}

}  // namespace

StrainFit fit(const bonds::Moment& moment, const Mandel& extension, const Mandel& plastic, double square,
              double shift) {
  return moment.dimension == 3 ? fit_of<6>(moment, extension, plastic, square, shift)
                               : fit_of<3>(moment, extension, plastic, square, shift);
}

void fit_total(const bonds::Moment& moment, const Mandel& extension, double total, double shift, StrainFit& result) {
  const StrainFit alone = fit(moment, extension, {}, total, shift);
  result.total = alone.square;
  result.total_slope = alone.slope;
}

Mandel volumetric(const bonds::Moment& moment) {
  Mandel all{};
  if (moment.dimension == 3)
    Eigen::Map<Column<6>>(all.data()) = inverse_of<6>(moment) * identity<6>();
  else
    Eigen::Map<Column<3>>(all.data()) = inverse_of<3>(moment) * identity<3>();
  return all;
}

std::array<double, 36> strain_modulus(const bonds::Moment& moment, double bulk, double shear) {
  return moment.dimension == 3 ? modulus_of<6>(moment, bulk, shear) : modulus_of<3>(moment, bulk, shear);
}

}  // namespace perinox::materials
