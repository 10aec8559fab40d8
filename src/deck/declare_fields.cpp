/// Declares the fields that a run can write to results.h5: what they are, their units, and which scenes have them.
#include <algorithm>

#include "declare.hpp"

namespace perinox::deck {
namespace {

const char* const always = "in every run";
const char* const vector_of_3 = "3: x, y, z; in 2-D z is 0";

std::vector<FieldDeclaration> common_fields() {
  const char* const tensor = "9: xx, xy, xz, yx, yy, yz, zx, zy, zz, along the axes of the undeformed body";
  const char* const strains = "in every run whose materials work on sums over the family, as all built-in ones do";
  return {
      {"displacement", "Displacement from the reference position; always written.", "length", vector_of_3, always},
      {"force", "Force that the bonds put on the particle, in 2-D per unit thickness; always written.", "force",
       vector_of_3, always},
      {"dilatation",
       "Change of volume over volume, a mean over the family; in plane stress of area over area, without "
       "the change of thickness, which strain zz has.",
       "-", "1", always},
      {"damage", "Share of the family that is lost, by weight: 0 none, 1 all; pre-cracks count from the start.", "-",
       "1", "in every run; 0 where there is neither a pre-crack nor a damage law"},
      {"stored_energy", "Elastic energy, which unloading gives back, a volume.", "energy/volume", "1", always},
      {"weighted_volume",
       "Sum over the family of influence times length squared times volume; with influence: inverse a length less.",
       "length^2*volume", "1", always},
      {"stress",
       "Stress tensor, from the force state; zz is that out of the plane in plane strain, and 0 in plane stress.",
       "stress", tensor, strains},
      {"strain",
       "Strain tensor that tells the stretch of the family's bonds best, the plastic part included; zz is that out of "
       "the plane in plane stress, and 0 in plane strain.",
       "-", tensor, strains},
      {"von_mises_stress", "Root of 3/2 of the stress deviator squared, in 2-D with the stress out of the plane.",
       "stress", "1", strains},
      {"plastic_work", "Energy that plastic flow has dissipated since the start, a volume.", "energy/volume", "1",
       "in every run; 0 where no material is elastic-plastic"},
      {"velocity", "Velocity.", "velocity", vector_of_3, "with dynamics: explicit"},
      {"fragment",
       "Number of the fragment that the particle belongs to, by its smallest particle id, from 0: what chains of "
       "intact "
       "bonds hold together.",
       "-", "1", "in every run; without cracks and damage laws a body that hangs together is one"},
  };
}

}  // namespace

std::vector<FieldDeclaration> declare_fields(const std::vector<ModelDeclaration>& models) {
  std::vector<FieldDeclaration> fields = common_fields();
  for (const ModelDeclaration& model : models)
    for (const FieldDeclaration& own : model.fields) {
      const auto same = [&](const FieldDeclaration& other) { return other.name == own.name; };
      if (std::none_of(fields.begin(), fields.end(), same)) fields.push_back(own);
    }
  return fields;
}

}  // namespace perinox::deck
