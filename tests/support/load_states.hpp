#pragma once
/// Deformed states of a scene in units of the yield strain: elastic, flowing, unloading, mixed, and finite with
/// rotation.
#include <ostream>
#include <string>
#include <vector>

#include "support/material_table.hpp"
#include "support/scenes.hpp"

namespace perinox::test {

enum class Flow { none, all, some };

struct LoadState {
  struct Stop {
    double strain;        ///< factor on the fixed strain tensor below, in yield strains
    double degrees = 0;   ///< rotation that is added
    bool graded = false;  ///< the strain grows with x from zero
  };
  std::string name;
  std::vector<Stop> stops;  ///< the last is the state under test; those before it are committed
  Flow flow;                ///< which points of an elastic-plastic scene flow
  bool needs_plasticity;

  friend void PrintTo(const LoadState& state, std::ostream* stream) { *stream << state.name; }
};

inline std::vector<LoadState> load_states() {
  return {
      {"small", {{0.1}}, Flow::none, false},
      {"finite_rotated", {{20, 35}}, Flow::all, false},  // strains of about 9 %
      {"flowing", {{4}}, Flow::all, true},
      {"unloading", {{4}, {3.9}}, Flow::none, true},
      {"unloading_rotated", {{4}, {3.9, 50}}, Flow::none, true},
      {"reverse", {{4}, {-4}}, Flow::all, true},
      {"mixed", {{0.4, 0, true}}, Flow::some, true},
      {"mixed_again", {{0.7, 0, true}, {-0.2, 20, true}}, Flow::some, true},
  };
}

/// Displacement of one stop: a strain with every component, a random part so that no two points are alike, and a
/// rotation.
inline Vector field_of(const mechanics::Scene& scene, const LoadState::Stop& stop) {
  const int d = scene.dimension();
  // The effective shear of this tensor is sqrt(2 e_d:e_d) = 2.4.
  const Matrix strain{{{1.0, 0.7, -0.4}, {0.7, -0.6, 0.3}, {-0.4, 0.3, -0.3}}};
  Matrix gradient{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) gradient[i][j] = stop.strain * yield_strain * strain[i][j] + (i == j ? 1 : 0);
  const double spacing = std::pow(scene.body().volume[0], 1.0 / d);
  Vector field =
      sum(affine_field(scene, gradient), 0.05 * stop.strain * yield_strain * spacing, random_field(scene, 1, 5));
  double extent = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) extent = std::max(extent, scene.body().position(i)[0]);
  const Matrix turn = rotation(stop.degrees, d);
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const double* position = scene.body().position(i);
    double* u = &field[static_cast<std::size_t>(i) * d];
    double deformed[3] = {}, turned[3] = {};
    for (int c = 0; c < d; ++c) deformed[c] = position[c] + u[c] * (stop.graded ? position[0] / extent : 1);
    for (int c = 0; c < d; ++c)
      for (int k = 0; k < d; ++k) turned[c] += turn[c][k] * deformed[k];
    for (int c = 0; c < d; ++c) u[c] = turned[c] - position[c];
  }
  return field;
}

/// The fields of all stops.
inline std::vector<Vector> fields_of(const mechanics::Scene& scene, const LoadState& state) {
  std::vector<Vector> fields;
  for (const LoadState::Stop& stop : state.stops) fields.push_back(field_of(scene, stop));
  return fields;
}

inline const char* name_of(deck::Quadrature quadrature) {
  switch (quadrature) {
    case deck::Quadrature::whole:
      return "whole";
    case deck::Quadrature::partial_volume:
      return "partial";
    case deck::Quadrature::taper_inside:
      return "taper";
    case deck::Quadrature::position_aware:
      return "aware";
    case deck::Quadrature::surface_energy:
      return "surface";
  }
  return "";
}

/// A small lattice of one material: 5 x 4 x 4 particles, in 2-D 8 x 6. Its spacing is not 1, so that a missing power of
/// it shows. The horizon reaches a few particles from every point, and the whole body from none.
inline mechanics::Scene small_scene(const MaterialRow& row, deck::Influence influence, deck::Quadrature quadrature,
                                    bool small_strain = false) {
  const bool flat = row.dimension == 2;
  deck::Deck deck = flat ? lattice_deck(deck::Dimension::plane_strain, {8, 6, 1}, 0.4, 2.2)
                         : lattice_deck(deck::Dimension::three, {5, 4, 4}, 0.4, 2.2);
  deck.influence = influence;
  deck.quadrature = quadrature;
  deck.small_strain = small_strain;
  return make_scene(deck, materials_of(row.make()));
}

}  // namespace perinox::test
