#pragma once
/// Families made by hand for tests of the point formulas: random bonds, weights of unequal neighbours, every influence
/// function.
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::test {

using Vector = std::vector<double>;

inline const char* name_of(deck::Influence influence) {
  switch (influence) {
    case deck::Influence::constant:
      return "constant";
    case deck::Influence::inverse:
      return "inverse";
    case deck::Influence::polynomial:
      return "polynomial";
  }
  return "";
}

struct RandomFamily {
  int dimension = 3;
  Vector length, influence, weight;
  double weighted_volume = 0;
  double continuum_weighted_volume = 0;

  materials::Family view() const {
    materials::Family family;
    family.dimension = dimension;
    family.count = static_cast<int>(length.size());
    family.length = length.data();
    family.influence = influence.data();
    family.weight = weight.data();
    family.weighted_volume = weighted_volume;
    family.continuum_weighted_volume = continuum_weighted_volume;
    return family;
  }

  /// The sum of a b omega weight.
  double influence_dot(const Vector& a, const Vector& b) const {
    double sum = 0;
    for (std::size_t j = 0; j < length.size(); ++j) sum += influence[j] * a[j] * b[j] * weight[j];
    return sum;
  }
  /// The sum of a b weight, which is the a . b of the formulas.
  double dot(const Vector& a, const Vector& b) const {
    double sum = 0;
    for (std::size_t j = 0; j < length.size(); ++j) sum += a[j] * b[j] * weight[j];
    return sum;
  }
  double dilatation(const Vector& extension) const {
    return dimension / weighted_volume * influence_dot(length, extension);
  }
};

/// Bonds have lengths of 0.3 to 1 horizon. The last one is exactly as long as the horizon, where the polynomial
/// influence is zero. Weights vary by a factor of 3. The continuum weighted volume differs from the family's own.
inline RandomFamily random_family(int dimension, deck::Influence influence, int count, unsigned seed) {
  const double horizon = 2.5;  // any length but 1, so that a missing power of it shows
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> part(0.3, 1.0);
  RandomFamily family;
  family.dimension = dimension;
  for (int j = 0; j < count; ++j) {
    const double share = j + 1 == count ? 1.0 : part(generator);
    const double length = horizon * share;
    family.length.push_back(length);
    switch (influence) {
      case deck::Influence::constant:
        family.influence.push_back(1);
        break;
      case deck::Influence::inverse:
        family.influence.push_back(1 / length);
        break;
      case deck::Influence::polynomial:
        family.influence.push_back(1 - 3 * share * share + 2 * share * share * share);
        break;
    }
    family.weight.push_back(part(generator));
  }
  family.weighted_volume = family.influence_dot(family.length, family.length);
  family.continuum_weighted_volume = 1.3 * family.weighted_volume;  // any factor but 1
  return family;
}

inline Vector random_values(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  Vector values(count);
  for (double& value : values) value = entry(generator);
  return values;
}

/// A random extension state scaled to the effective shear `shear`, gamma^2 = d(d+2)/m sum omega e_d^2 weight
/// (docs/theory.md, section 3), on top of the dilatation `dilatation`.
inline Vector random_extension(const RandomFamily& family, double shear, double dilatation, unsigned seed) {
  const double d = family.dimension;
  Vector extension = random_values(family.length.size(), seed);
  const double theta = family.dilatation(extension);
  for (std::size_t j = 0; j < extension.size(); ++j) extension[j] -= theta * family.length[j] / d;
  const double unit = std::sqrt(d * (d + 2) / family.weighted_volume * family.influence_dot(extension, extension));
  for (std::size_t j = 0; j < extension.size(); ++j)
    extension[j] = extension[j] * shear / unit + dilatation * family.length[j] / d;
  return extension;
}

/// The results of one evaluation.
struct Evaluation {
  materials::PointResponse response;
  Vector force_state, point_history, bond_history;

  double potential() const { return response.stored_energy + response.hardening_potential; }
};

/// One point of a material with its committed history.
class MaterialPoint {
 public:
  MaterialPoint(const materials::Material& material, const RandomFamily& family)
      : material_(material),
        family_(family),
        point_(material.history().point.size(), 0.0),
        bond_(family.length.size() * static_cast<std::size_t>(material.history().per_bond), 0.0) {}

  Evaluation evaluate(const Vector& extension) const {
    Evaluation result;
    // These start as not-a-number, because the material must write all of them.
    result.force_state.assign(family_.length.size(), std::nan(""));
    result.point_history.assign(point_.size(), std::nan(""));
    result.bond_history.assign(bond_.size(), std::nan(""));
    result.response =
        material_.respond(family_.view(), extension.data(), {point_.data(), bond_.data()}, result.force_state.data(),
                          {result.point_history.data(), result.bond_history.data()});
    return result;
  }
  void commit(const Evaluation& evaluation) {
    point_ = evaluation.point_history;
    bond_ = evaluation.bond_history;
  }
  materials::ModulusState modulus(const Vector& extension,
                                  deck::TangentForm form = deck::TangentForm::consistent) const {
    materials::ModulusState state;
    material_.modulus(family_.view(), extension.data(), {point_.data(), bond_.data()}, form, state);
    return state;
  }
  /// The change dt that the modulus state gives for a change de.
  Vector apply(const materials::ModulusState& state, const Vector& change) const {
    const std::size_t count = change.size();
    Vector result(count);
    for (std::size_t j = 0; j < count; ++j) result[j] = state.diagonal()[j] * change[j];
    for (int r = 0; r < state.rank(); ++r) {
      const auto& term = state.term(r);
      const auto radial = [&](std::size_t j) { return family_.influence[j] * family_.length[j]; };
      double contraction = 0;
      for (std::size_t j = 0; j < count; ++j)
        contraction += (term.radial ? radial(j) : term.q[j]) * change[j] * family_.weight[j];
      for (std::size_t j = 0; j < count; ++j)
        result[j] += term.coefficient * contraction * (term.radial ? radial(j) : term.p[j]);
    }
    return result;
  }

  const RandomFamily& family() const { return family_; }
  const Vector& committed_point() const { return point_; }
  const Vector& committed_bond() const { return bond_; }

 private:
  const materials::Material& material_;
  const RandomFamily& family_;
  Vector point_, bond_;
};

inline double largest_magnitude(const Vector& values) {
  double largest = 0;
  for (double value : values) largest = std::abs(value) > largest || value != value ? std::abs(value) : largest;
  return largest;
}

/// Largest difference over the largest entry of `expected`.
inline double relative_difference(const Vector& found, const Vector& expected) {
  Vector difference(expected.size());
  for (std::size_t j = 0; j < expected.size(); ++j) difference[j] = found[j] - expected[j];
  return largest_magnitude(difference) / largest_magnitude(expected);
}

}  // namespace perinox::test
