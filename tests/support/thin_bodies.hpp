#pragma once
/// Bodies one particle thick that fall on each other.
#include <string>

namespace perinox::test {

struct ThinScene {
  const char* name;
  const char* dimension;
  const char* resting;  ///< min and max of the box of the body at rest
  const char* falling;
  char axis;  ///< axis along which the other body falls, downwards
};

inline const ThinScene thin_scenes[] = {
    {"strips", "plane-stress", "min: [0, 0], max: [30, 1]", "min: [15, 1.2], max: [16, 31.2]", 'y'},
    {"strips between two particles", "plane-stress", "min: [0, 0], max: [30, 1]", "min: [14.5, 1.2], max: [15.5, 31.2]",
     'y'},
    {"strips flat on each other", "plane-stress", "min: [0, 0], max: [12, 1]", "min: [0.3, 1.2], max: [12.3, 2.2]",
     'y'},
    {"plates", "3", "min: [0, 0, 0], max: [12, 12, 1]", "min: [0, 5.5, 1.2], max: [12, 6.5, 9.2]", 'z'},
    {"rows", "3", "min: [0, 0, 0], max: [20, 1, 1]", "min: [9.5, -9.5, 1.2], max: [10.5, 10.5, 2.2]", 'z'},
};

/// A deck of the two bodies. far: adds a thick body far away, of another spacing.
inline std::string thin_deck(const ThinScene& scene, bool far) {
  const std::string velocity = std::string("velocity: {") + scene.axis + ": -2e4}";
  const bool solid = scene.axis == 'z';
  std::string deck = std::string("dimension: ") + scene.dimension + "\nbody:\n  - {name: resting, shape: {box: {" +
                     scene.resting + "}}, spacing: 1, material: steel}\n  - {name: falling, shape: {box: {" +
                     scene.falling + "}}, spacing: 1, material: steel}\n";
  if (far)
    deck += std::string("  - {name: far, shape: {box: {") +
            (solid ? "min: [1000, 0, 0], max: [1006, 6, 6]" : "min: [1000, 0], max: [1012, 12]") +
            "}}, spacing: 0.75, material: steel}\n";
  return deck + R"(
bond_bodies: false
horizon: {length: 3.015}
quadrature: whole
materials: {steel: {model: elastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9}}
dynamics: explicit
explicit: {contact: {}, time_step: 5e-8}
initial_velocity: [{set: falling, )" +
         velocity + R"(}]
boundary: []
steps: {end: 4e-5, count: 80}
history: [{name: above, displacement: falling, component: )" +
         scene.axis + "}, {name: below, displacement: resting, component: " + scene.axis + "}]\n";
}

}  // namespace perinox::test
