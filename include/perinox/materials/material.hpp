#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"
#include "perinox/materials/family.hpp"

namespace perinox::materials {

/// Elastic moduli of the dimension at hand, stress: kappa (d-dimensional bulk modulus) and mu.
struct ElasticModuli {
  double bulk = 0;
  double shear = 0;
};

/// An ordinary material: the energy, force state and modulus state of a point. Nothing else in the code knows what the
/// material is. Stateless: all history is handed in. Where the force state is t<xi> = omega (radial xi + shear (e -
/// e_p) + back e_p) with coefficients that depend on sums over the family only, a material gives state() and
/// modulus(sums), and the fast sweeps do the rest. Any other law says so in from_sums() and gives respond() and
/// modulus(family), bond by bond; its scenes take the loops over stored bonds.
class Material {
 public:
  virtual ~Material() = default;

  virtual HistoryLayout history() const { return {}; }
  virtual bool from_sums() const { return true; }
  /// True where state() gives `pressure` and modulus(sums) `bulk`, so that the strain may be fitted (quadrature
  /// position-aware): the energy has to be one of dilatation and deviatoric extension. Otherwise its points keep
  /// `radial`.
  virtual bool takes_fit() const { return false; }
  /// True where state() gives `back`: kinematic hardening. The sums then have `total`.
  virtual bool has_back_stress() const { return false; }

  /// The point's answer to the sums at a state under trial. Reads the committed point history, writes every entry of
  /// the trial one (both [HistoryLayout::point.size()]).
  virtual PointState state(const FamilySums& sums, const double* committed, double* trial) const;

  /// Work that plastic flow has dissipated up to a state, energy a volume, of its point history.
  virtual double plastic_work(const double* /*point*/) const { return 0; }

  /// dt/de of state() at the same sums and committed history.
  /// `printed` gives the modulus state as the source paper prints it, where that differs.
  virtual PointModulus modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const;

  /// Scalar force state t<xi> (force a volume squared) of one family with extension state e, bond by bond: state() and
  /// its sums. extension, force_state: [count]. Writes every entry of the trial history.
  virtual PointResponse respond(const Family& family, const double* extension, CommittedHistory committed,
                                double* force_state, TrialHistory trial) const;

  /// dt/de of respond() at the same extension and committed history.
  virtual void modulus(const Family& family, const double* extension, CommittedHistory committed,
                       deck::TangentForm form, ModulusState& modulus) const;

  /// Moduli of the local solid whose energy kappa theta^2/2 + mu e_dev:e_dev the unyielded, undamaged material has
  /// under uniform strain in `dimension` (3 or 2) dimensions. Both positive. What the preconditioner's coarse grid is
  /// made of.
  virtual ElasticModuli elastic_moduli(int dimension) const = 0;
  /// False where dt/de is not symmetric: the linear solver then needs GMRES.
  virtual bool symmetric() const { return true; }
  /// One line for `perinox check`: what is carried and the derived constants.
  virtual std::string summary() const = 0;
  /// One sentence, with its place in the deck, on constants that can be computed with but are hardly meant; "" if all
  /// are ordinary.
  virtual std::string remark() const { return ""; }
};

/// A material model: what the deck may say about it, and how it is made.
struct Model {
  deck::ModelDeclaration declaration;
  /// Throws InputError at the deck's line: inconsistent constants, a dimension the model does not have.
  std::function<std::unique_ptr<Material>(const deck::Material&, deck::Dimension)> make;
};

/// Adds a model to the registry; called by PERINOX_REGISTER_MATERIAL before main. Returns true.
bool add_model(Model model);
/// Declarations of all models, by name, for the deck's schema.
std::vector<deck::ModelDeclaration> declarations();
/// The schema of a deck with every registered material: what deck::read() wants.
deck::Schema full_schema();
/// Throws InputError if the model is unknown.
std::unique_ptr<Material> make(const deck::Material& material, deck::Dimension dimension);

/// In a material's .cpp: registers it; nothing else in the code has to be edited.
#define PERINOX_REGISTER_MATERIAL(name, model) \
  [[maybe_unused]] const bool name##_registered = ::perinox::materials::add_model(model)

}  // namespace perinox::materials
