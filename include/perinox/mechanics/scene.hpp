#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/bonds.hpp"
#include "perinox/bonds/components.hpp"
#include "perinox/bonds/lattice_families.hpp"
#include "perinox/bonds/pair_families.hpp"
#include "perinox/materials/material.hpp"
#include "perinox/medium/model.hpp"

namespace perinox::mechanics {

class PlasticExtension;

/// How the bonds are stored: as a stencil where the body is a lattice, or always as pairs (for comparison).
enum class Layout { automatic, pairs };

/// The two ends of a bond, local indices, in any order.
using BondEnds = std::array<LocalIndex, 2>;

/// The discrete model: particles, families, and what each is made of. Constant during a run but for bonds that break.
class Scene final : public medium::Model {
 public:
  /// materials: one per deck material, in the deck's order. bonds: of this body, and of nothing else.
  Scene(body::Body body, const bonds::Bonds& bonds, std::vector<std::unique_ptr<materials::Material>> materials,
        Layout layout = Layout::automatic, bool small_strain = false);
  /// Finds the families itself. Collective; throws InputError.
  Scene(const deck::Deck& deck, body::Body body, double horizon,
        std::vector<std::unique_ptr<materials::Material>> materials, Layout layout = Layout::automatic);
  Scene(Scene&&) noexcept;
  ~Scene() override;

  const bonds::Families& families() const { return families_; }
  /// One of the two is null.
  const bonds::LatticeFamilies* lattice() const { return lattice_.get(); }
  const bonds::PairFamilies* pairs() const { return pairs_.get(); }
  /// Every bond in plain arrays, made at the first call: 28 bytes a directed bond.
  const bonds::Bonds& bonds() const;

  /// Breaks bonds, each with an end of this rank's. Called on all ranks, which tell the same of bonds between them,
  /// with an empty list where none is this rank's. m and the fit of the strain stay those of the family before, so that
  /// its stiffness is gone and the energy stays one energy (docs/fracture.md). plastic: of the state in which they
  /// break; null: none of them has flowed. Throws std::logic_error for a bond that is not there, and where the loops
  /// over stored bonds are taken.
  void break_bonds(const std::vector<BondEnds>& ends, const PlasticExtension* plastic = nullptr);
  /// In place of what break_bonds has noted: Families::broken_extension of another run's same bonds.
  void set_broken_extension(std::vector<bonds::BrokenExtension> extension);
  /// Changes with every break_bonds, alike on all ranks.
  std::uint64_t bonds_version() const { return bonds_version_; }
  /// Ids of the ends of the bonds broken so far, the smaller first, in the order of breaking; of those whose smaller id
  /// this rank owns.
  const std::vector<std::array<GlobalId, 2>>& broken() const { return broken_; }

  const materials::Material& material(LocalIndex i) const { return *materials_[body_.material[i]]; }
  const std::vector<std::unique_ptr<materials::Material>>& materials() const { return materials_; }
  /// Where each owned particle's point history lies in the state arrays: [owned + 1]. A material without history takes
  /// no room.
  const std::vector<std::int64_t>& point_history() const { return point_history_; }
  /// False where any material has no point formulas of sums: then the loops over stored bonds are taken, and bond
  /// history is kept plainly: that of particle i's bonds begins at bond_history()[i] [owned + 1].
  bool from_sums() const { return from_sums_; }
  const std::vector<std::int64_t>& bond_history() const { return bond_history_; }
  /// True if any particle's material carries plastic extension in the sweeps' own order: alike on every rank, as
  /// collective work has to go by.
  bool plastic() const { return plastic_; }
  /// The same of this rank's own particles, for work that no other rank takes part in.
  bool plastic_here() const { return plastic_here_; }
  /// True if bonds keep their reference direction: no geometric term anywhere.
  bool small_strain() const override { return small_strain_; }

  int largest_family() const { return largest_family_; }

  /// Who is bonded to whom, as the layout has it; the scene must outlive it.
  bonds::BondGraph bond_graph() const override;
  long long bonds_gone() const override { return static_cast<long long>(broken_.size()); }
  double horizon() const override { return families_.horizon; }
  /// True where some material has history variables.
  bool remembers() const override;
  std::optional<medium::LocalElasticity> local_elasticity() const override;
  /// The bonds of particle i as the materials see them; makes bonds().
  materials::Family family(LocalIndex i) const;
  /// False where any material's modulus state is not symmetric.
  bool symmetric() const override;
  /// Names of all point history variables of all materials, each once.
  std::vector<std::string> point_history_names() const;

 private:
  void complete();
  void drop_fits();
  void keep_extension(LocalIndex i, LocalIndex j, double weight, double length, double plastic);
  const std::vector<double>& basis() const;

  bonds::Families families_;
  std::unique_ptr<bonds::LatticeFamilies> lattice_;
  std::unique_ptr<bonds::PairFamilies> pairs_;
  std::vector<std::unique_ptr<materials::Material>> materials_;
  std::vector<std::int64_t> point_history_;
  std::vector<std::int64_t> bond_history_;  ///< empty if from_sums()
  bool from_sums_ = true;
  bool plastic_ = false, plastic_here_ = false;
  bool small_strain_ = false;
  int largest_family_ = 0;
  std::vector<std::array<GlobalId, 2>> broken_;
  std::uint64_t bonds_version_ = 0;
  mutable std::unique_ptr<bonds::Bonds> bonds_;
  mutable std::vector<double> basis_;  ///< [bonds * mandel_size] xi N; made with the first family that needs it
};

/// Particles, bonds and materials of a deck. Collective; throws InputError. report may be null.
Scene build_scene(const deck::Deck& deck, const Communicator& communicator, body::PartitionReport* report = nullptr);

}  // namespace perinox::mechanics
