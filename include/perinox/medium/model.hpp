#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/bonds/bond_graph.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::medium {

/// The local linear elasticity that a model comes to in fields that are smooth over its horizon.
struct LocalElasticity {
  std::vector<materials::ElasticModuli> moduli;  ///< [materials] of Body::material
  bool regular = false;                          ///< the particles are those of one lattice
  /// [owned] share of a particle's interactions that are gone; kept by the model.
  const std::vector<double>* damage = nullptr;
};

/// What is discretised, as it is seen by those who load it and solve for its equilibrium: particles with a displacement
/// each, and who acts on whom. Nothing here changes with the displacement.
class Model {
 public:
  virtual ~Model() = default;

  const body::Body& body() const { return body_; }
  int dimension() const { return body_.dimension; }
  int owned() const { return body_.owned; }
  int local() const { return body_.local(); }
  std::size_t owned_unknowns() const { return static_cast<std::size_t>(body_.owned) * body_.dimension; }
  std::size_t local_unknowns() const { return static_cast<std::size_t>(body_.local()) * body_.dimension; }

  /// Who acts on whom; the model must outlive it.
  virtual bonds::BondGraph bond_graph() const = 0;
  /// Interactions that are gone since t = 0 and that this rank counts.
  virtual long long bonds_gone() const { return 0; }
  /// Length up to which particles act on each other.
  virtual double horizon() const = 0;
  /// False where some tangent is not symmetric.
  virtual bool symmetric() const = 0;
  /// True where displacements are taken as infinitely small.
  virtual bool small_strain() const = 0;
  /// True where some particle's force depends on the way that its displacement has come.
  virtual bool remembers() const = 0;
  /// Empty where nothing of this kind is known: then no preconditioner has a coarse grid.
  virtual std::optional<LocalElasticity> local_elasticity() const { return std::nullopt; }

 protected:
  explicit Model(body::Body body) : body_(std::move(body)) {}
  Model(Model&&) = default;

  body::Body body_;
};

}  // namespace perinox::medium
