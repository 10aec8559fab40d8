#include "elastic_plastic.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plane_plastic.hpp"

namespace perinox::materials {

namespace {
// The yield surface f = 0 is a kink. A point on it counts as elastic up to rounding, so that Newton does not flip
// between the two tangents (docs/theory.md, section 3).
constexpr double kink = 1e-12;
const std::vector<std::string> point_history{"plastic_multiplier", "equivalent_plastic_strain"};
constexpr int multiplier = 0;
constexpr int equivalent_strain = 1;
const double root3 = std::sqrt(3.0);
/// Ratio of yield stress in shear to shear modulus that no real material comes near: its strain at yield would be a
/// tenth.
constexpr double most_yield_over_shear = 0.1;
}  // namespace

ElasticPlastic::ElasticPlastic(const Parameters& parameters)
    : parameters_(parameters),
      curve_(parameters.curve()),
      overlay_(parameters.kinematic_shear / parameters.shear),
      inner_(1 / (1 + overlay_)) {}

HistoryLayout ElasticPlastic::history() const { return {point_history, 1}; }

ElasticPlastic::Return ElasticPlastic::radial_return(const FamilySums& sums, const double* committed) const {
  const double d = sums.dimension;
  const double m = sums.weighted_volume;
  Return r;
  r.alpha = d * (d + 2) * parameters_.shear / sums.deviatoric_volume();
  if (parameters_.with_dilatation) r.dilatation = d / m * sums.extension;
  r.strain_square = sums.square_about(r.dilatation / d);
  r.trial_norm = r.alpha * std::sqrt(r.strain_square);
  // psi0 = d(d+2) tau^2/(2m) and beta = sqrt(2 psi0) = c tau; with the continuum m and omega = 1 this is Eq. 51.
  r.yield_scale = std::sqrt(d * (d + 2) /
                            (parameters_.continuum_yield ? sums.continuum_weighted_volume : sums.deviatoric_volume()));
  const double plastic_shear = root3 * committed[equivalent_strain];
  r.beta = r.yield_scale * curve_.stress(plastic_shear);
  if (r.trial_norm <= r.beta * (1 + kink)) return r;

  // N = beta(lambda) (1 + (1 + h) alpha Delta lambda) with Delta gamma = Delta lambda beta c, which is linear in Delta
  // gamma.
  r.yielding = true;
  const double falls = (1 + overlay_) * r.alpha / (r.yield_scale * r.yield_scale);
  const double driving = r.trial_norm / r.yield_scale;
  const HardeningCurve::Flow flow =
      curve_.flow(plastic_shear, [&](double stress, double slope) { return (driving - stress) / (slope + falls); });
  r.plastic_shear = flow.strain;
  r.beta = r.yield_scale * flow.stress;
  r.beta_slope = flow.slope / (flow.slope + falls);
  r.scale = r.beta / r.trial_norm;
  r.potential = flow.work;
  return r;
}

PointState ElasticPlastic::state(const FamilySums& sums, const double* committed, double* trial) const {
  const double d = sums.dimension;
  const Return r = radial_return(sums, committed);
  PointState point;
  point.mean = r.dilatation / d;
  point.shear = r.alpha * (r.scale + overlay_) * inner_;
  point.back = r.alpha * overlay_ * inner_;
  point.pressure = parameters_.bulk * r.dilatation;
  point.radial = d * point.pressure / sums.weighted_volume - point.shear * point.mean;
  if (parameters_.with_dilatation) point.radial += (point.shear - point.back) * tilt(sums);
  point.flow = 1 - r.scale;  // e_p + Delta lambda t_d/omega (45)
  const double delta_lambda = r.yielding ? (1 / r.scale - 1) / r.alpha * inner_ : 0;  // (44)
  trial[multiplier] = committed[multiplier] + delta_lambda;
  trial[equivalent_strain] = committed[equivalent_strain] + r.plastic_shear / root3;

  PointResponse& response = point.response;
  response.dilatation = r.dilatation;
  const double total = overlay_ > 0 ? overlay_ * sums.total_about(point.mean) : 0;
  const auto energy = [&](double scale) {
    const double deviatoric = (scale * scale * r.strain_square + total) * inner_;
    return 0.5 * (parameters_.bulk * r.dilatation * r.dilatation + r.alpha * deviatoric);
  };
  response.stored_energy = energy(r.scale);
  response.unflowed_energy = energy(1);
  response.dissipation = r.potential;  // Delta lambda beta^2 without hardening
  response.hardening_potential = r.potential;
  response.yielding = r.yielding;
  return point;
}

double ElasticPlastic::plastic_work(const double* point) const { return curve_.work(root3 * point[equivalent_strain]); }

PointModulus ElasticPlastic::modulus(const FamilySums& sums, const double* committed, deck::TangentForm form) const {
  const double d = sums.dimension;
  const double m = sums.weighted_volume;
  const Return r = radial_return(sums, committed);
  PointModulus point;
  point.mean = r.dilatation / d;
  point.shear = r.alpha * (r.scale + overlay_) * inner_;
  const bool printed = form == deck::TangentForm::printed && r.yielding;
  if (parameters_.with_dilatation) {
    point.mean -= tilt(sums);
    point.bulk = parameters_.bulk;
    // Eq. 65 as printed lacks the factor 3/m of the dilatation's gradient (docs/theory.md, section 7).
    point.radial =
        printed ? 3 * parameters_.bulk / m - point.shear / 3 : (d * d * parameters_.bulk - point.shear * m) / (m * m);
  }
  if (!r.yielding) return point;
  // The rank-one state is t_trial = alpha q with its coefficient -alpha beta/N^3. Hardening adds alpha beta'/N^2, and
  // the part in parallel takes none of it. As printed, the third term carries a Delta(zeta - xi) that (63) does not
  // have. Read as one quadrature weight, it keeps only the diagonal. N = alpha sqrt(strain_square) is inserted so that
  // no power of alpha is left, which a small or large horizon would overflow.
  point.flow = inner_ * (r.beta_slope * r.trial_norm - r.beta) / (r.strain_square * std::sqrt(r.strain_square));
  point.diagonal_only = printed;
  return point;
}

ElasticModuli ElasticPlastic::elastic_moduli(int dimension) const {
  // Without the dilatation term W = alpha/2 sum omega e^2, which is (d+2) mu theta^2/(2d) for e = xi theta/d.
  return {parameters_.with_dilatation ? parameters_.bulk : (dimension + 2) * parameters_.shear / dimension,
          parameters_.shear};
}

std::string ElasticPlastic::Parameters::hardening() const {
  std::string text = table                 ? fmt::format("hardening by a table of {} rows", table->lines())
                     : hardening_shear > 0 ? fmt::format("hardening {:g} in shear", hardening_shear)
                                           : std::string("perfectly plastic");
  if (kinematic_shear > 0) {
    if (!table && hardening_shear == 0) text = "isotropic part perfectly plastic";
    text += fmt::format(", kinematic hardening {:g} in shear", kinematic_shear);
  }
  return text;
}

std::string ElasticPlastic::Parameters::remark() const {
  const double yield = curve().stress(0);
  if (yield <= most_yield_over_shear * shear) return "";
  return deck::placed(yield_location,
                      fmt::format("the yield stress, {:g} in tension and {:g} in shear, is above {:g} of the shear "
                                  "modulus, {:g}; check that both are in the same unit",
                                  root3 * yield, yield, most_yield_over_shear, shear));
}

std::string ElasticPlastic::summary() const {
  return fmt::format(
      "elastic-plastic, k {:g}, mu {:g}, yield {:g} in shear ({:g} in tension), {}, {} yield value, "
      "history: e_p a bond, lambda and equivalent plastic strain a point",
      parameters_.bulk, parameters_.shear, curve_.stress(0), root3 * curve_.stress(0), parameters_.hardening(),
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

deck::Key table_choice() {
  deck::Key choice = stress_choice(
      "hardening_table",
      "Yield stress over plastic strain, in place of yield_stress and hardening_modulus: a CSV file with the columns "
      "plastic_strain (from 0, rising) and yield_stress; straight between the rows, constant after the last. Stresses "
      "are forces per undeformed area and strains changes of length per undeformed length, without their elastic part; "
      "what a table of true stress over logarithmic strain means is met up to 2.5 % of stretch.",
      false, true, "Of a uniaxial tension test, with its plastic strain along the bar.",
      "Of pure shear, with the plastic shear strain.");
  for (deck::Key& entry : choice.keys) {
    entry.type = deck::Type::path;
    entry.unit.clear();
    entry.minimum.reset();
  }
  return choice;
}

deck::ModelDeclaration declaration() {
  deck::ModelDeclaration model{
      "elastic-plastic",
      "Ordinary state-based plasticity (Mitchell 2011, Eq. 27-65, corrected), perfect, with isotropic hardening, "
      "linear or from a table, and with linear kinematic hardening; in plane strain and plane stress with the plastic "
      "strain out of the plane.",
      elastic_keys()};
  model.keys.push_back(
      stress_choice("yield_stress",
                    "Yield stress, a force per undeformed area; say in which test it was measured. "
                    "Needed unless there is a hardening_table. With deformation: finite the "
                    "true stress of a bar goes beyond it: by 3 % at 2.5 % of stretch, by 61 % at 30 %.",
                    false, false, "In uniaxial tension; the yield stress in shear is this over sqrt(3) (Eq. 56).",
                    "In pure shear (Eq. 57)."));
  model.keys.push_back(
      stress_choice("hardening_modulus", "Linear isotropic hardening; left out: perfect plasticity.", false, true,
                    "Slope of the tension yield stress over equivalent plastic strain; in shear it is a third of this.",
                    "Slope of the shear yield stress over plastic shear strain."));
  model.keys.push_back(table_choice());
  model.keys.push_back(stress_choice(
      "kinematic_hardening_modulus",
      "Linear kinematic hardening (Prager), alone or beside the isotropic one: the yield surface moves with the "
      "plastic "
      "strain, and yields earlier in reverse.",
      false, true, "Slope of the back stress of a tension test over plastic strain; in shear it is a third of this.",
      "Slope of the back stress in shear over plastic shear strain."));
  deck::Key scaling;
  scaling.name = "yield_scaling";
  scaling.type = deck::Type::word;
  scaling.words = {"discrete", "continuum"};
  scaling.fallback = "discrete";
  scaling.sentence =
      "discrete: the yield value uses each point's own weighted volume; continuum: that of a full continuous "
      "neighbourhood, Eq. 51, as other codes have it.";
  model.keys.push_back(scaling);
  const std::string where = "where a material is elastic-plastic; 0 in the others' particles";
  model.fields = {
      {point_history[multiplier],
       "Plastic multiplier lambda, summed over the steps: the plastic extension of a bond grows by it times "
       "the deviatoric force state; greater than 0 where anything has flowed.",
       "length^2*volume/stress", "1", where},
      {point_history[equivalent_strain],
       "Equivalent plastic strain, summed over the steps: in a tension test the plastic strain along the bar.", "-",
       "1", where},
      {"plastic_strain_zz", "Plastic strain out of the plane.", "-", "1", "in 2-D, " + where, true}};
  return model;
}

/// The slope in shear that the key gives; 0 if the key was left out.
double shear_slope(const deck::Material& material, const char* key) {
  if (!material.parameters.has(key)) return 0;
  const deck::Value& slope = material.parameters.at(key);
  return slope.has("shear") ? slope.at("shear").number() : slope.at("tension").number() / 3;
}

/// Reads the hardening table into p, which has everything else.
void read_table(const deck::Material& material, deck::Dimension dimension, ElasticPlastic::Parameters& p) {
  for (const char* key : {"yield_stress", "hardening_modulus"})
    if (material.parameters.has(key))
      deck::refuse(material.parameters.at(key).location(),
                   fmt::format("material {} has both {} and hardening_table, but the table says both the yield stress "
                               "and its hardening; keep one",
                               material.name, key));
  const deck::Value& choice = material.parameters.at("hardening_table");
  const bool tension = choice.has("tension");
  const deck::Value& path = choice.at(tension ? "tension" : "shear");
  p.table = read_hardening_table(path.text(), path.location(), tension);
  p.yield_location = path.location();
  const double lowest = p.table->lowest_slope();
  if (lowest >= 0) return;
  if (p.continuum_yield)
    deck::refuse(path.location(),
                 "a hardening table whose yield stress falls needs yield_scaling: discrete, where its slope can be "
                 "compared with the shear modulus");
  // The least rate at which the driving stress falls as the plastic shear strain grows. The return is unique if the
  // yield stress falls more slowly.
  const ElasticConstants constants{p.bulk, p.shear};
  const double falls =
      p.kinematic_shear +
      (dimension == deck::Dimension::plane_stress ? constants.bulk_of(dimension) / 3 : constants.shear);
  if (-lowest >= falls)
    deck::refuse(
        path.location(),
        fmt::format("the yield stress of this hardening table falls with a slope of {:g} in {}, at or beyond "
                    "{:g}, where the return to it is no longer unique; let it fall more slowly",
                    tension ? 3 * lowest : lowest, tension ? "tension" : "shear", tension ? -3 * falls : -falls));
}

std::unique_ptr<Material> make_elastic_plastic(const deck::Material& material, deck::Dimension dimension) {
  const ElasticConstants constants = elastic_constants(material);
  ElasticPlastic::Parameters p;
  p.bulk = constants.bulk;
  p.shear = constants.shear;
  p.kinematic_shear = shear_slope(material, "kinematic_hardening_modulus");
  p.continuum_yield = material.parameters.at("yield_scaling").text() == "continuum";
  if (material.parameters.has("hardening_table")) {
    read_table(material, dimension, p);
  } else {
    if (!material.parameters.has("yield_stress"))
      deck::refuse(
          material.location,
          fmt::format("material {} needs the key yield_stress (a map with exactly one of tension or shear), or "
                      "a hardening_table",
                      material.name));
    const deck::Value& yield = material.parameters.at("yield_stress");
    p.yield_location = yield.at(yield.has("shear") ? "shear" : "tension").location();
    p.yield_shear = yield.has("shear") ? yield.at("shear").number() : yield.at("tension").number() / root3;
    p.hardening_shear = shear_slope(material, "hardening_modulus");
  }
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
