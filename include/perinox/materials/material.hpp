#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"
#include "perinox/materials/family.hpp"

namespace perinox::materials {

/// Elastic moduli of the dimension at hand, both stresses: kappa (the d-dimensional bulk modulus) and mu.
struct ElasticModuli {
  double bulk = 0;
  double shear = 0;
};

/// An ordinary material: it gives the energy, the force state and the modulus state of a point. Nothing else in the
/// code knows what the material is. It has no state of its own; all history is handed in. Where the force state is
/// t<xi> = omega (radial xi + shear (e - e_p) + back e_p), with coefficients that depend on sums over the family only,
/// a material implements state() and modulus(sums), and the fast sweeps do the rest. Any other law returns false from
/// from_sums() and implements respond() and modulus(family), bond by bond. Its scenes use the loops over stored bonds.
class Material {
 public:
  virtual ~Material() = default;

  /// The history variables that the material carries.
  virtual HistoryLayout history() const { return {}; }
  /// True if state() and modulus(sums) give the material's answer, false if respond() and modulus(family) do.
  virtual bool from_sums() const { return true; }
  /// True if state() gives `pressure` and modulus(sums) gives `bulk`, so that the strain may be fitted (quadrature
  /// position-aware). The energy must be one of dilatation and deviatoric extension. Points of other materials keep
  /// `radial`.
  virtual bool takes_fit() const { return false; }
  /// True if state() gives `back`, which is kinematic hardening. The sums then have `total`.
  virtual bool has_back_stress() const { return false; }

  /// The point's answer to the sums at a trial state. It reads the committed point history and writes every entry of
  /// the trial one (both [HistoryLayout::point.size()]).
  virtual PointState state(const FamilySums& sums, const double* committed, double* trial) const;

  /// Work that plastic flow has dissipated up to a state, energy a volume. point: the point history of that state.
  virtual double plastic_work(const double* /*point*/) const { return 0; }

  /// The derivative dt/de of state() at the same sums and committed history. With form `printed` it is the modulus
  /// state as the source paper prints it, where that differs (docs/theory.md, section 7).
  virtual PointModulus modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const;

  /// The scalar force state t<xi> (force a volume squared) of one family with extension state e, bond by bond. The
  /// default computes the sums and calls state(). extension, force_state: [count]. Writes every entry of the trial
  /// history.
  virtual PointResponse respond(const Family& family, const double* extension, CommittedHistory committed,
                                double* force_state, TrialHistory trial) const;

  /// The derivative dt/de of respond() at the same extension and committed history.
  virtual void modulus(const Family& family, const double* extension, CommittedHistory committed,
                       deck::TangentForm form, ModulusState& modulus) const;

  /// Moduli of the local solid with the energy kappa theta^2/2 + mu e_dev:e_dev that the unyielded, undamaged material
  /// has under uniform strain in `dimension` (3 or 2) dimensions. Both are positive. The background grid's elements, of
  /// which the preconditioner's coarse level is made, have these moduli.
  virtual ElasticModuli elastic_moduli(int dimension) const = 0;
  /// False if dt/de is not symmetric. The linear solver then needs GMRES.
  virtual bool symmetric() const { return true; }
  /// One line for `perinox check` with the history that is carried and the derived constants.
  virtual std::string summary() const = 0;
  /// One sentence, with its place in the deck, about constants that can be computed with but are hardly meant. It is ""
  /// if all of them are ordinary.
  virtual std::string remark() const { return ""; }
};

/// A material model: what the deck may say about it, and how it is made.
struct Model {
  deck::ModelDeclaration declaration;
  /// Makes the material. Throws InputError at the deck's line for inconsistent constants and for a dimension that the
  /// model does not have.
  std::function<std::unique_ptr<Material>(const deck::Material&, deck::Dimension)> make;
};

/// Adds a model to the registry and returns true. PERINOX_REGISTER_MATERIAL calls it before main.
bool add_model(Model model);
/// Declarations of all models, by name, for the deck's schema.
std::vector<deck::ModelDeclaration> declarations();
/// The schema of a deck with every registered material, as deck::read() needs it.
deck::Schema full_schema();
/// Makes the material that the deck declares. Throws InputError if the model is unknown.
std::unique_ptr<Material> make(const deck::Material& material, deck::Dimension dimension);

/// Registers a material. It stands in the material's .cpp file; nothing else in the code has to be edited.
#define PERINOX_REGISTER_MATERIAL(name, model) \
  [[maybe_unused]] const bool name##_registered = ::perinox::materials::add_model(model)

}  // namespace perinox::materials
