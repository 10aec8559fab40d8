#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/bonds.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::mechanics {

/// Where each owned particle's history lies in the state arrays. A material without history takes no room.
struct HistoryOffsets {
  std::vector<std::int64_t> point;  ///< [owned + 1]
  std::vector<std::int64_t> bond;   ///< [owned + 1]
};

/// The discrete model: particles, families, and what each is made of. Constant during a run.
class Scene {
 public:
  /// materials: one per deck material, in the deck's order.
  Scene(body::Body body, bonds::Bonds bonds, std::vector<std::unique_ptr<materials::Material>> materials);

  const body::Body& body() const { return body_; }
  const bonds::Bonds& bonds() const { return bonds_; }
  const materials::Material& material(LocalIndex i) const { return *materials_[body_.material[i]]; }
  const std::vector<std::unique_ptr<materials::Material>>& materials() const { return materials_; }
  const HistoryOffsets& history() const { return history_; }

  int dimension() const { return body_.dimension; }
  int owned() const { return body_.owned; }
  int local() const { return body_.local(); }
  std::size_t owned_unknowns() const { return static_cast<std::size_t>(body_.owned) * body_.dimension; }
  std::size_t local_unknowns() const { return static_cast<std::size_t>(body_.local()) * body_.dimension; }
  int largest_family() const { return largest_family_; }

  /// The bonds of particle i as the materials see them.
  materials::Family family(LocalIndex i) const;
  /// False where any material's modulus state is not symmetric.
  bool symmetric() const;
  /// Names of all point history variables of all materials, each once.
  std::vector<std::string> point_history_names() const;

 private:
  body::Body body_;
  bonds::Bonds bonds_;
  std::vector<std::unique_ptr<materials::Material>> materials_;
  HistoryOffsets history_;
  int largest_family_ = 0;
};

/// Particles, bonds and materials of a deck. Collective; throws InputError. report may be null.
Scene build_scene(const deck::Deck& deck, const Communicator& communicator, body::PartitionReport* report = nullptr);

}  // namespace perinox::mechanics
