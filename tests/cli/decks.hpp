#pragma once
/// Small decks that run in a fraction of a second, for the tests to break.
#include <string>

namespace perinox::cli {

inline const std::string base_deck = R"(title: base
dimension: 3
body:
  - name: block
    shape: {box: {min: [0, 0, 0], max: [3, 3, 4]}}
    spacing: 1.0
    material: steel
horizon: {ratio: 2.015}
influence: constant
quadrature: whole
materials:
  steel:
    model: elastic-plastic
    bulk_modulus: 160e3
    shear_modulus: 80e3
    yield_stress: {tension: 203.1}
sets:
  foot: {where: "z < 1"}
  head: {where: "z > 3"}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {z: "0.01*t"}}
steps: {end: 1.0, count: 2}
solver:
  tangent: matrix-free
  newton: {tolerance: 1e-8}
  linear: {preconditioner: automatic}
output: {every: 1, fields: [displacement, force]}
history:
  - {name: pull, reaction: head, component: z}
)";

inline const std::string flat_deck = R"(dimension: plane-strain
body: [{name: plate, shape: {box: {min: [0, 0], max: [3, 3]}}, spacing: 1, material: steel}]
horizon: {ratio: 2.015}
materials:
  steel: {model: elastic, bulk_modulus: 160e3, shear_modulus: 80e3}
sets: {left: {where: "x < 1"}}
boundary: [{set: left, displacement: {x: 0, y: 0}}]
history: [{name: pull, reaction: left, component: x}]
)";

/// A deck that reads cloud.csv and field.csv.
inline const std::string cloud_deck = R"(dimension: 3
body: [{name: cloud, shape: {file: cloud.csv}, material: steel}]
horizon: {length: 1.5}
materials: {steel: {model: elastic, bulk_modulus: 160e3, shear_modulus: 80e3}}
boundary: [{set: all, displacement: {table: field.csv}}]
)";

inline const std::string cloud = "x,y,z,volume\n0,0,0,1\n1,0,0,1\n0,1,0,1\n1,1,0,1\n";

inline const std::string field = "t,x,y,z,ux,uy,uz\n1,0,0,0,0,0,0\n1,1,0,0,0.1,0,0\n1,0,1,0,0,0,0\n1,1,1,0,0.1,0,0\n";

}  // namespace perinox::cli
