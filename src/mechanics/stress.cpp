#include "perinox/mechanics/stress.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "perinox/mechanics/family_loops.hpp"

namespace perinox::mechanics {

namespace {

using bonds::Mandel;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 6, 6>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
/// Below this ratio of M's eigenvalues a family does not tell a strain.
constexpr double singular = 1e-6;
constexpr double same = 1e-10;

Column column(const Mandel& values, int n) { return Eigen::Map<const Column>(values.data(), n); }

Matrix pseudo_inverse(const Matrix& m) {
  const Eigen::SelfAdjointEigenSolver<Matrix> values(m);
  Column inverse = values.eigenvalues();
  const double least = singular * inverse[inverse.size() - 1];
  for (double& value : inverse) value = value > least ? 1 / value : 0;
  return values.eigenvectors() * inverse.asDiagonal() * values.eigenvectors().transpose();
}

/// Places of xx yy zz yz xz xy in xx xy xz yy yz zz.
constexpr std::size_t place[6] = {0, 3, 5, 4, 2, 1};

}  // namespace

Stress::Stress(const Scene& scene) : scene_(scene) {
  const auto owned = static_cast<std::size_t>(scene.owned());
  stress_.assign(6 * owned, 0.0);
  strain_.assign(6 * owned, 0.0);
  von_mises_.assign(owned, 0.0);
  find_moments();
  loops_ = FamilyLoops::make_for_tensors(scene, scene.small_strain());
}

Stress::~Stress() = default;

/// S(e) is linear in e: the small displacements of the unit strains give M column by column.
void Stress::find_moments() {
  const int d = scene_.dimension(), n = bonds::mandel_size(d);
  const auto owned = static_cast<std::size_t>(scene_.owned());
  const auto loops = FamilyLoops::make_for_tensors(scene_, true);
  const std::vector<double> shift(owned, 0.0);
  const PlasticExtension nothing_flowed;
  std::vector<StrainSums> sums(static_cast<std::size_t>(n));
  std::vector<double> u(scene_.local_unknowns());
  for (int k = 0; k < n; ++k) {
    const int row = k < d ? k : d == 2 ? 0 : (k + 1) % 3, col = k < d ? k : d == 2 ? 1 : (k + 2) % 3;
    std::fill(u.begin(), u.end(), 0.0);
    for (LocalIndex i = 0; i < scene_.local(); ++i) {
      const double* x = scene_.body().position(i);
      double* to = &u[static_cast<std::size_t>(i) * d];
      if (row == col) {
        to[row] = x[row];
      } else {
        to[row] = x[col] / std::sqrt(2.0);
        to[col] = x[row] / std::sqrt(2.0);
      }
    }
    loops->strain_sums(u.data(), shift.data(), nothing_flowed, sums[static_cast<std::size_t>(k)]);
  }
  family_of_.resize(owned);
  std::int32_t last = -1;
  const auto differs = [&](const Square& a, const Square& b) {
    double largest = 0, difference = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      largest = std::max(largest, std::abs(a[k]));
      difference = std::max(difference, std::abs(a[k] - b[k]));
    }
    return difference > same * largest;
  };
  std::int32_t whole = -1;  // of the largest family so far: most of a lattice's are like it
  double most = 0;
  for (std::size_t i = 0; i < owned; ++i) {
    Family family;
    for (int k = 0; k < n; ++k)
      for (int l = 0; l < n; ++l)
        family.moment[static_cast<std::size_t>(l * n + k)] = sums[static_cast<std::size_t>(k)].fit[i][l];
    for (const std::int32_t known : {last, whole})
      if (known >= 0 && !differs(family.moment, families_[static_cast<std::size_t>(known)].moment)) last = known;
    if (last < 0 || differs(family.moment, families_[static_cast<std::size_t>(last)].moment)) {
      Eigen::Map<Matrix>(family.inverse.data(), n, n) = pseudo_inverse(Eigen::Map<Matrix>(family.moment.data(), n, n));
      last = static_cast<std::int32_t>(families_.size());
      families_.push_back(family);
    }
    if (scene_.families().weighted_volume[i] > most) {
      most = scene_.families().weighted_volume[i];
      whole = last;
    }
    family_of_[i] = last;
  }
}

void Stress::evaluate(const Committed& committed) {
  const int d = scene_.dimension(), n = bonds::mandel_size(d);
  if (bonds_version_ != scene_.bonds_version()) {  // strain and stress are those of what is left of the family
    families_.clear();
    find_moments();
    loops_->bonds_changed();
    bonds_version_ = scene_.bonds_version();
  }
  StrainSums strains;
  loops_->strain_sums(committed.displacement().data(), committed.mean().data(), committed.plastic(), strains);
  std::vector<double> trial;
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    materials::StrainFit fit;
    const materials::FamilySums sums =
        family_sums(scene_, committed, strains, i, strains.fit[at], strains.plastic_fit[at], fit);
    const double* history = committed.point_history(scene_, i);
    trial.resize(scene_.material(i).history().point.size());
    const materials::PointState point = scene_.material(i).state(sums, history, trial.data());

    Mandel along{};  // t = omega (shear (e - e_p) + back e_p + xi N . along)
    if (const bonds::Moment* moment = scene_.families().moment(i))
      along = force_of_fit(*moment, fit, point);
    else
      std::fill_n(along.begin(), d, point.radial);
    const Family& family = families_[static_cast<std::size_t>(family_of_[at])];
    const Eigen::Map<const Matrix> moment(family.moment.data(), n, n), inverse(family.inverse.data(), n, n);
    Mandel stress{}, strain{};
    Eigen::Map<Column>(strain.data(), n) = inverse * column(strains.fit[at], n);
    Eigen::Map<Column>(stress.data(), n) = point.shear * column(strains.fit[at], n) -
                                           (point.shear - point.back) * column(strains.plastic_fit[at], n) +
                                           moment * column(along, n);
    put(i, strain, point.response.strain_zz, strain_);
    put(i, stress, point.response.stress_zz, stress_);

    const double* s = &stress_[6 * at];
    const double mean = (s[0] + s[3] + s[5]) / 3;
    double square = 2 * (s[1] * s[1] + s[2] * s[2] + s[4] * s[4]);
    for (const int c : {0, 3, 5}) square += (s[c] - mean) * (s[c] - mean);
    von_mises_[at] = std::sqrt(1.5 * square);
  }
}

void Stress::put(LocalIndex i, const Mandel& value, double zz, std::vector<double>& to) const {
  const double root2 = std::sqrt(2.0);
  double* tensor = &to[6 * static_cast<std::size_t>(i)];
  if (scene_.dimension() == 2) {
    tensor[0] = value[0], tensor[3] = value[1], tensor[5] = zz, tensor[1] = value[2] / root2;
    return;
  }
  for (std::size_t k = 0; k < 6; ++k) tensor[place[k]] = k < 3 ? value[k] : value[k] / root2;
}

}  // namespace perinox::mechanics
