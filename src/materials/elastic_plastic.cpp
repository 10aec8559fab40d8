#include "perinox/materials/elastic_plastic.hpp"

#include <fmt/format.h>

#include <cmath>

#include "perinox/materials/plane_plastic.hpp"

namespace perinox::materials {

namespace {
// f = 0 is a kink: a point that sits on the yield surface up to rounding counts as elastic, so that Newton does not
// flip between the two tangents (formulation 3).
constexpr double kink = 1e-12;
const std::vector<std::string> point_history{"plastic_multiplier", "equivalent_plastic_strain"};
constexpr int multiplier = 0;
constexpr int equivalent_strain = 1;
const double root3 = std::sqrt(3.0);
}  // namespace

ElasticPlastic::ElasticPlastic(const Parameters& parameters) : parameters_(parameters) {}

HistoryLayout ElasticPlastic::history() const { return {point_history, 1}; }

ElasticPlastic::Return ElasticPlastic::radial_return(const FamilySums& sums, const double* committed) const {
  const double d = sums.dimension;
  const double m = sums.weighted_volume;
  Return r;
  r.alpha = d * (d + 2) * parameters_.shear / m;
  if (parameters_.with_dilatation) r.dilatation = d / m * sums.extension;
  r.strain_square = sums.square_about(r.dilatation / d);
  r.trial_norm = r.alpha * std::sqrt(r.strain_square);
  // psi0 = d(d+2) tau^2/(2m), beta = sqrt(2 psi0) = c tau; with the continuum m and omega = 1 this is Eq. 51.
  r.yield_scale = std::sqrt(d * (d + 2) / (parameters_.continuum_yield ? sums.continuum_weighted_volume : m));
  const double tau = parameters_.yield_shear + parameters_.hardening_shear * root3 * committed[equivalent_strain];
  r.beta = r.yield_scale * tau;
  if (r.trial_norm <= r.beta * (1 + kink)) return r;

  // N = beta(lambda) (1 + alpha Delta lambda) with Delta gamma = Delta lambda beta c: linear in Delta gamma.
  r.yielding = true;
  const double flow_modulus = parameters_.hardening_shear + r.alpha / (r.yield_scale * r.yield_scale);
  r.plastic_shear = (r.trial_norm / r.yield_scale - tau) / flow_modulus;
  r.beta = r.yield_scale * (tau + parameters_.hardening_shear * r.plastic_shear);
  r.beta_slope = parameters_.hardening_shear / flow_modulus;
  r.scale = r.beta / r.trial_norm;
  r.potential = (tau + 0.5 * parameters_.hardening_shear * r.plastic_shear) * r.plastic_shear;
  return r;
}

PointState ElasticPlastic::state(const FamilySums& sums, const double* committed, double* trial) const {
  const double d = sums.dimension;
  const Return r = radial_return(sums, committed);
  PointState point;
  point.mean = r.dilatation / d;
  point.shear = r.scale * r.alpha;
  point.pressure = parameters_.bulk * r.dilatation;
  point.radial = d * point.pressure / sums.weighted_volume - point.shear * point.mean;
  point.flow = 1 - r.scale;                                                  // e_p + Delta lambda t_d/omega (45)
  const double delta_lambda = r.yielding ? (1 / r.scale - 1) / r.alpha : 0;  // (44)
  trial[multiplier] = committed[multiplier] + delta_lambda;
  trial[equivalent_strain] = committed[equivalent_strain] + r.plastic_shear / root3;

  PointResponse& response = point.response;
  response.dilatation = r.dilatation;
  response.stored_energy =
      0.5 * (parameters_.bulk * r.dilatation * r.dilatation + r.alpha * r.scale * r.scale * r.strain_square);
  response.dissipation = r.potential;  // Delta lambda beta^2 without hardening
  response.hardening_potential = r.potential;
  response.yielding = r.yielding;
  return point;
}

double ElasticPlastic::plastic_work(const double* point) const {
  const double plastic_shear = root3 * point[equivalent_strain];
  return (parameters_.yield_shear + 0.5 * parameters_.hardening_shear * plastic_shear) * plastic_shear;
}

PointModulus ElasticPlastic::modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const {
  const double d = sums.dimension;
  const double m = sums.weighted_volume;
  const Return r = radial_return(sums, committed);
  PointModulus point;
  point.mean = r.dilatation / d;
  point.shear = r.scale * r.alpha;
  const bool printed = form == deck::TangentForm::printed && r.yielding;
  if (parameters_.with_dilatation) {
    point.bulk = parameters_.bulk;
    // Eq. 65 as printed lacks the factor 3/m of the dilatation's gradient.
    point.radial =
        printed ? 3 * parameters_.bulk / m - point.shear / 3 : (d * d * parameters_.bulk - point.shear * m) / (m * m);
  }
  if (!r.yielding) return point;
  // The rank-one state t_trial = alpha q with its coefficient -alpha beta/N^3; hardening adds alpha beta'/N^2. As
  // printed, the third term carries a Delta(zeta - xi) that (63) does not have: read as one quadrature weight, it keeps
  // only the diagonal.
  const double n = r.trial_norm;
  point.flow = r.alpha * r.alpha * r.alpha * (r.beta_slope * n - r.beta) / (n * n * n);
  point.diagonal_only = printed;
  return point;
}

ElasticModuli ElasticPlastic::elastic_moduli(int dimension) const {
  // Without the dilatation term W = alpha/2 sum omega e^2, which at e = xi theta/d is (d+2) mu theta^2/(2d).
  return {parameters_.with_dilatation ? parameters_.bulk : (dimension + 2) * parameters_.shear / dimension,
          parameters_.shear};
}

std::string ElasticPlastic::summary() const {
  return fmt::format(
      "elastic-plastic, k {:g}, mu {:g}, yield {:g} in shear ({:g} in tension), {}, {} yield value, "
      "history: e_p a bond, lambda and equivalent plastic strain a point",
      parameters_.bulk, parameters_.shear, parameters_.yield_shear, root3 * parameters_.yield_shear,
      parameters_.hardening_shear > 0 ? fmt::format("hardening {:g} in shear", parameters_.hardening_shear)
                                      : std::string("perfectly plastic"),
      parameters_.continuum_yield ? "continuum" : "discrete");
}

namespace {

deck::Key stress_choice(const char* name, const char* sentence, bool required, bool zero_allowed, const char* tension,
                        const char* shear) {
  deck::Key choice;
  choice.name = name;
  choice.type = deck::Type::choice;
  choice.sentence = sentence;
  choice.required = required;
  for (const auto& [key, text] : {std::pair{"tension", tension}, std::pair{"shear", shear}}) {
    deck::Key entry;
    entry.name = key;
    entry.unit = "stress";
    entry.sentence = text;
    entry.minimum = 0;
    entry.exclusive_minimum = !zero_allowed;
    choice.keys.push_back(entry);
  }
  return choice;
}

deck::ModelDeclaration declaration() {
  deck::ModelDeclaration model{
      "elastic-plastic",
      "Ordinary state-based plasticity (Mitchell 2011, Eq. 27-65, corrected), perfect or with "
      "linear isotropic hardening; in plane strain and plane stress with the plastic strain out of the "
      "plane.",
      elastic_keys()};
  model.keys.push_back(stress_choice("yield_stress", "Yield stress; say in which test it was measured.", true, false,
                                     "In uniaxial tension; the yield stress in shear is this over sqrt(3) (Eq. 56).",
                                     "In pure shear (Eq. 57)."));
  model.keys.push_back(
      stress_choice("hardening_modulus", "Linear isotropic hardening; left out: perfect plasticity.", false, true,
                    "Slope of the tension yield stress over equivalent plastic strain; in shear it is a third of this.",
                    "Slope of the shear yield stress over plastic shear strain."));
  deck::Key scaling;
  scaling.name = "yield_scaling";
  scaling.type = deck::Type::word;
  scaling.words = {"discrete", "continuum"};
  scaling.fallback = "discrete";
  scaling.sentence =
      "discrete: the yield value uses each point's own weighted volume; continuum: that of a full continuous "
      "neighbourhood, Eq. 51, as other codes have it.";
  model.keys.push_back(scaling);
  model.fields = point_history;
  model.fields.push_back("plastic_strain_zz");  // in 2-D
  return model;
}

std::unique_ptr<Material> make_elastic_plastic(const deck::Material& material, deck::Dimension dimension) {
  const ElasticConstants constants = elastic_constants(material);
  ElasticPlastic::Parameters p;
  p.bulk = constants.bulk;
  p.shear = constants.shear;
  const deck::Value& yield = material.parameters.at("yield_stress");
  p.yield_shear = yield.has("shear") ? yield.at("shear").number() : yield.at("tension").number() / root3;
  if (material.parameters.has("hardening_modulus")) {
    const deck::Value& hardening = material.parameters.at("hardening_modulus");
    p.hardening_shear = hardening.has("shear") ? hardening.at("shear").number() : hardening.at("tension").number() / 3;
  }
  p.continuum_yield = material.parameters.at("yield_scaling").text() == "continuum";
  p.with_dilatation = material.parameters.at("dilatation").boolean();
  if (dimension == deck::Dimension::three) return std::make_unique<ElasticPlastic>(p);
  if (p.continuum_yield)
    deck::refuse(material.parameters.at("yield_scaling").location(),
                 "the continuum yield value (Eq. 51) is that of a solid; in 2-D leave yield_scaling out");
  if (!p.with_dilatation)
    deck::refuse(material.parameters.at("dilatation").location(),
                 "plasticity in the plane needs the dilatation, which the strain out of the plane follows; leave "
                 "dilatation out, or use dimension: 3");
  return std::make_unique<PlanePlastic>(p, dimension);
}

PERINOX_REGISTER_MATERIAL(elastic_plastic, (Model{declaration(), make_elastic_plastic}));

}  // namespace

}  // namespace perinox::materials
