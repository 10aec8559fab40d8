#pragma once
/// Small decks whose bonds break or that move in time. Each takes a few seconds at most.
#include <string>

namespace perinox::test {

/// A notched bar, held on the left and pulled on the right by a force of 60 t, that snaps at t < 0.2.
inline std::string snapping_bar_of(const std::string& horizon_ratio, const std::string& steps,
                                   const std::string& density = "density: 1.0e-9, ") {
  return R"(
dimension: plane-stress
body: [{name: bar, shape: {box: {min: [0, 0], max: [24, 6]}}, spacing: 1, material: brittle}]
horizon: {ratio: )" +
         horizon_ratio + R"(}
cracks: [{segment: {start: [12, 0], end: [12, 2]}}]
materials:
  brittle: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, )" +
         density + R"(damage: {energy_release_rate: 0.05}}
sets: {wall: {where: "x < 3"}, pulled: {where: "x > 21"}}
boundary:
  - {set: wall, displacement: {x: 0, y: 0}}
  - {set: pulled, force: {x: "60*t"}}
fracture: {unbreakable: [wall, pulled]}
steps: )" +
         steps +
         R"(
history:
  - {name: stretch, displacement: pulled, component: x}
  - {name: held, reaction: wall, component: x}
)";
}

/// The bar snaps in step 1. It takes 270 time steps at t = 0.2 until the pieces are at rest.
inline const std::string snapping_bar = snapping_bar_of("3.015", "{end: 1, count: 5}");

/// Three strong parts and two weak ones, torn apart in step 1. Both weak parts break alike and the middle comes loose.
inline const std::string torn_chain = R"(
dimension: plane-stress
body:
  - {name: left, shape: {box: {min: [0, 0], max: [4, 6]}}, spacing: 1, material: strong}
  - {name: one, shape: {box: {min: [4, 0], max: [6, 6]}}, spacing: 1, material: weak}
  - {name: middle, shape: {box: {min: [6, 0], max: [12, 6]}}, spacing: 1, material: strong}
  - {name: other, shape: {box: {min: [12, 0], max: [14, 6]}}, spacing: 1, material: weak}
  - {name: right, shape: {box: {min: [14, 0], max: [18, 6]}}, spacing: 1, material: strong}
horizon: {ratio: 2.015}
materials:
  strong: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3}
  weak: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, damage: {critical_stretch: 0.004}}
sets: {wall: {where: "x < 2"}, grip: {where: "x > 16"}}
boundary:
  - {set: wall, displacement: {x: 0, y: 0}}
  - {set: grip, displacement: {x: "0.8*t", y: 0}}
fracture: {pass_share: 0.5}
steps: {end: 1, count: 8}
history:
  - {name: pull, reaction: grip, component: x}
  - {name: middle, displacement: middle, component: x}
)";

/// An edge crack grows in converged passes through steps 3 to 5, and single particles come loose.
inline const std::string torn_plate = R"(
dimension: plane-stress
body: [{name: plate, shape: {box: {min: [0, 0], max: [20, 20]}}, spacing: 1, material: brittle}]
horizon: {ratio: 3.015}
cracks: [{segment: {start: [0, 10], end: [6, 10]}}]
materials: {brittle: {model: elastic, young_modulus: 1000, poisson_ratio: 0.3, density: 1.0e-9, damage: {energy_release_rate: 0.05}}}
sets: {bottom: {where: "y < 3"}, top: {where: "y > 17"}}
boundary:
  - {set: bottom, displacement: {x: 0, y: 0}}
  - {set: top, displacement: {x: 0, y: "t"}}
fracture: {unbreakable: [bottom, top], pass_share: 0.005}
fallback: none
steps: {end: 0.06, count: 6}
history: [{name: pull, reaction: top, component: y}]
)";

/// Blocks of a ductile metal collide: contact, flow, damping and bonds that break in 160 time steps of five rows.
inline const std::string smashed_blocks = R"(
dimension: 3
body:
  - {name: left, shape: {box: {min: [0, 0, 0], max: [8, 4, 4]}}, spacing: 1, material: steel}
  - {name: right, shape: {box: {min: [8.5, 0, 0], max: [16.5, 4, 4]}}, spacing: 1, material: steel}
bond_bodies: false
horizon: {ratio: 2.015}
materials: {steel: {model: elastic-plastic, young_modulus: 210e3, poisson_ratio: 0.3, density: 7.85e-9, yield_stress: {tension: 400}, damage: {critical_stretch: 0.02}}}
dynamics: explicit
explicit: {contact: {distance: 0.9}, damping: 1e3, safety: 0.8}
initial_velocity:
  - {set: left, velocity: {x: 1e5, z: 2e4}}
  - {set: right, velocity: {x: -1e5}}
boundary: []
steps: {end: 2e-5, count: 5}
history:
  - {name: left, displacement: left, component: x}
  - {name: right, displacement: right, component: x}
)";

/// A bar with an elastic and a plastic half, pulled and pushed back.
inline const std::string half_plastic_bar = R"yaml(
dimension: 3
body:
  - {name: elastic, shape: {box: {min: [0, 0, 0], max: [4, 4, 12]}}, spacing: 1, material: stiff}
  - {name: plastic, shape: {box: {min: [0, 0, 12], max: [4, 4, 24]}}, spacing: 1, material: metal}
horizon: {ratio: 2.015}
materials:
  stiff: {model: elastic, bulk_modulus: 160e3, shear_modulus: 80e3}
  metal: {model: elastic-plastic, bulk_modulus: 160e3, shear_modulus: 80e3, yield_stress: {tension: 200}}
sets: {foot: {where: "z < 2"}, head: {where: "z > 22"}}
boundary:
  - {set: foot, displacement: {x: 0, y: 0, z: 0}}
  - {set: head, displacement: {x: "0.01*t", z: "0.12*sin(5*t)"}}
steps: {end: 1, count: 4}
history:
  - {name: pull, reaction: head, component: z}
  - {name: flowed, yielded: all}
)yaml";

}  // namespace perinox::test
