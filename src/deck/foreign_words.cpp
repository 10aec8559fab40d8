#include "foreign_words.hpp"

#include <algorithm>
#include <array>

namespace perinox::deck {
namespace {

struct Word {
  const char* foreign;
  const char* own;
};

constexpr std::array<Word, 56> words{{
    {"E", "young_modulus"},
    {"Youngs_modulus", "young_modulus"},
    {"youngs_modulus", "young_modulus"},
    {"elastic_modulus", "young_modulus"},
    {"nu", "poisson_ratio"},
    {"poissons_ratio", "poisson_ratio"},
    {"G", "shear_modulus"},
    {"mu", "shear_modulus"},
    {"K", "bulk_modulus"},
    {"k", "bulk_modulus"},
    {"kappa", "bulk_modulus"},
    {"lambda", "lame_lambda"},
    {"rho", "density"},
    {"sigma_y", "yield_stress"},
    {"sy", "yield_stress"},
    {"yield_strength", "yield_stress"},
    {"hardening", "hardening_modulus"},
    {"type", "model"},
    {"law", "model"},
    {"Gc", "energy_release_rate"},
    {"G_c", "energy_release_rate"},
    {"G0", "energy_release_rate"},
    {"fracture_energy", "energy_release_rate"},
    {"s0", "critical_stretch"},
    {"s_c", "critical_stretch"},
    {"dx", "spacing"},
    {"h", "spacing"},
    {"mesh_size", "spacing"},
    {"delta", "horizon"},
    {"geometry", "shape"},
    {"dt", "time_step"},
    {"timestep", "time_step"},
    {"bc", "boundary"},
    {"bcs", "boundary"},
    {"boundary_conditions", "boundary"},
    {"loads", "boundary"},
    {"load", "boundary"},
    {"bodies", "body"},
    {"precracks", "cracks"},
    {"crack", "cracks"},
    {"nodesets", "sets"},
    {"nodes", "set"},
    {"region", "set"},
    {"disp", "displacement"},
    {"direction", "component"},
    {"force", "reaction"},
    {"reaction_force", "reaction"},
    {"name", "set"},
    {"strain_energy", "stored_energy"},
    {"energy", "stored_energy"},
    {"energy_density", "stored_energy"},
    {"sigma", "stress"},
    {"epsilon", "strain"},
    {"PEEQ", "equivalent_plastic_strain"},
    {"peeq", "equivalent_plastic_strain"},
    {"u", "displacement"},
}};

constexpr std::array<Word, 11> advice{{
    {"thickness",
     "2-D bodies have thickness 1: forces, reactions and energies are per unit thickness, so divide given forces by "
     "the "
     "thickness"},
    {"gravity", "give it as a load, boundary: - {set: all, body_force: {...}}, density times acceleration"},
    {"g", "give gravity as a load, boundary: - {set: all, body_force: {...}}, density times acceleration"},
    {"units", "a deck has no key for units: give all numbers in one consistent set of them, such as mm, N and MPa"},
    {"unit", "a deck has no key for units: give all numbers in one consistent set of them, such as mm, N and MPa"},
    {"mesh",
     "bodies are filled with particles by body[].shape and spacing, or read from a point cloud, shape: {file: ...}"},
    {"fixed", "hold a set by a load, boundary: - {set: ..., displacement: {x: 0, y: 0, z: 0}}"},
    {"temperature", "perinox computes no temperatures and no thermal strain"},
    {"thermal_expansion", "perinox computes no temperatures and no thermal strain"},
    {"threads", "the number of processes is mpirun's: mpirun -np 4 perinox run DECK"},
    {"processes", "the number of processes is mpirun's: mpirun -np 4 perinox run DECK"},
}};

}  // namespace

std::string own_word_for(const std::string& word, const std::vector<std::string>& known) {
  for (const Word& one : words)
    if (word == one.foreign && std::count(known.begin(), known.end(), one.own) > 0) return one.own;
  return "";
}

std::string advice_on(const std::string& word) {
  for (const Word& one : advice)
    if (word == one.foreign) return one.own;
  return "";
}

}  // namespace perinox::deck
