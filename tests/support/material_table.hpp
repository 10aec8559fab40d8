#pragma once
/// All materials and the states in which they are tested. A new material needs one row in materials() and nothing else.
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "materials/elastic.hpp"
#include "materials/elastic_plastic.hpp"
#include "materials/plane_plastic.hpp"
#include "support/families.hpp"

namespace perinox::test {

/// Steel-like constants in units that make stresses of order 100 (MPa), from Mitchell's section 8.
constexpr double bulk = 67.5e3;
constexpr double shear = 25.9e3;
constexpr double yield_shear = 117.26;                // about 203.1/sqrt(3)
constexpr double yield_strain = yield_shear / shear;  // shear strain at first yield
constexpr double hardening_shear = 0.1 * shear;       // strong enough to tell from perfect plasticity
constexpr double kinematic_shear = 0.15 * shear;

/// What an elastic-plastic row promises beyond its potential.
struct YieldSurface {
  double stress = 0;              ///< tau_y
  double hardening = 0;           ///< d tau_y/d gamma_p
  bool continuum = false;         ///< beta from the continuum weighted volume
  bool volume_preserving = true;  ///< e_p is deviatoric
  bool plane = false;             ///< part of the yield value is out of the plane
  double kinematic = 0;           ///< d back stress/d gamma_p
  bool table = false;             ///< a yield stress that falls after a rise, in place of `hardening`

  std::optional<materials::HardeningCurve> curve() const {
    if (!table) return {};
    return materials::HardeningCurve({{0, stress}, {1.1 * yield_strain, 1.3 * stress}, {4.3 * yield_strain, stress}});
  }
  double yield_stress(double gamma) const { return table ? curve()->stress(gamma) : stress + hardening * gamma; }
};

struct MaterialRow {
  std::string name;
  std::string model;  ///< name in the registry
  int dimension = 3;
  std::function<std::unique_ptr<materials::Material>()> make;
  std::vector<YieldSurface> surface = {};  ///< empty, or one entry

  friend void PrintTo(const MaterialRow& row, std::ostream* stream) { *stream << row.name; }
};

inline std::vector<MaterialRow> material_table() {
  using materials::Elastic;
  using materials::ElasticPlastic;
  const materials::ElasticConstants k_mu{bulk, shear};
  const auto elastic = [](double kappa, bool dilatation) {
    return [=] { return std::make_unique<Elastic>(kappa, shear, dilatation); };
  };
  const auto plastic = [](const YieldSurface& surface) {
    return [=] {
      return std::make_unique<ElasticPlastic>(ElasticPlastic::Parameters{bulk, shear, surface.stress, surface.hardening,
                                                                         surface.continuum, surface.volume_preserving,
                                                                         surface.kinematic, surface.curve()});
    };
  };
  const auto plane = [](const YieldSurface& surface, deck::Dimension dimension) {
    return [=] {
      return std::make_unique<materials::PlanePlastic>(
          ElasticPlastic::Parameters{bulk, shear, surface.stress, surface.hardening, false, true, surface.kinematic,
                                     surface.curve()},
          dimension);
    };
  };
  const YieldSurface flat{yield_shear, 0, false, true, true};
  const YieldSurface flat_hardening{yield_shear, hardening_shear, false, true, true};
  const YieldSurface perfect{yield_shear, 0, false, true};
  const YieldSurface hardening{yield_shear, hardening_shear, false, true};
  const YieldSurface continuum{yield_shear, 0, true, true};
  const YieldSurface continuum_hardening{yield_shear, hardening_shear, true, true};
  const YieldSurface bondwise{yield_shear, hardening_shear, false, false};
  const YieldSurface combined{yield_shear, hardening_shear, false, true, false, kinematic_shear};
  const YieldSurface continuum_combined{yield_shear, hardening_shear, true, true, false, kinematic_shear};
  const YieldSurface bondwise_combined{yield_shear, hardening_shear, false, false, false, kinematic_shear};
  const YieldSurface table{yield_shear, 0, false, true, false, 0, true};
  const YieldSurface flat_combined{yield_shear, hardening_shear, false, true, true, kinematic_shear};
  const YieldSurface flat_table{yield_shear, 0, false, true, true, kinematic_shear, true};
  return {
      {"elastic", "elastic", 3, elastic(bulk, true)},
      {"elastic_plane_strain", "elastic", 2, elastic(k_mu.bulk_of(deck::Dimension::plane_strain), true)},
      {"elastic_plane_stress", "elastic", 2, elastic(k_mu.bulk_of(deck::Dimension::plane_stress), true)},
      {"elastic_dilatation_off", "elastic", 3, elastic(bulk, false)},
      {"plastic_perfect", "elastic-plastic", 3, plastic(perfect), {perfect}},
      {"plastic_hardening", "elastic-plastic", 3, plastic(hardening), {hardening}},
      {"plastic_continuum", "elastic-plastic", 3, plastic(continuum), {continuum}},
      {"plastic_continuum_hardening", "elastic-plastic", 3, plastic(continuum_hardening), {continuum_hardening}},
      {"plastic_dilatation_off", "elastic-plastic", 3, plastic(bondwise), {bondwise}},
      {"plane_strain_perfect", "elastic-plastic", 2, plane(flat, deck::Dimension::plane_strain), {flat}},
      {"plane_strain_hardening",
       "elastic-plastic",
       2,
       plane(flat_hardening, deck::Dimension::plane_strain),
       {flat_hardening}},
      {"plane_stress_perfect", "elastic-plastic", 2, plane(flat, deck::Dimension::plane_stress), {flat}},
      {"plane_stress_hardening",
       "elastic-plastic",
       2,
       plane(flat_hardening, deck::Dimension::plane_stress),
       {flat_hardening}},
      {"plastic_combined", "elastic-plastic", 3, plastic(combined), {combined}},
      {"plastic_continuum_combined", "elastic-plastic", 3, plastic(continuum_combined), {continuum_combined}},
      {"plastic_dilatation_off_combined", "elastic-plastic", 3, plastic(bondwise_combined), {bondwise_combined}},
      {"plastic_table", "elastic-plastic", 3, plastic(table), {table}},
      {"plane_strain_combined",
       "elastic-plastic",
       2,
       plane(flat_combined, deck::Dimension::plane_strain),
       {flat_combined}},
      {"plane_stress_table_kinematic",
       "elastic-plastic",
       2,
       plane(flat_table, deck::Dimension::plane_stress),
       {flat_table}},
  };
}

/// A load path in effective shear, in units of the yield strain. The last entry is the state under test; those before
/// it are committed one after the other. Entries on one `direction` are proportional to each other.
struct LoadPath {
  struct Stop {
    double shear;
    unsigned direction;
  };
  std::string name;
  std::vector<Stop> stops;
  bool yields;  ///< an elastic-plastic point flows in the last stop

  friend void PrintTo(const LoadPath& path, std::ostream* stream) { *stream << path.name; }
};

inline std::vector<LoadPath> load_paths() {
  return {
      {"elastic", {{0.5, 1}}, false},           {"loading", {{3.0, 1}}, true},
      {"turning", {{3.0, 1}, {3.5, 2}}, true},  {"unloading", {{3.0, 1}, {2.6, 1}}, false},
      {"reverse", {{3.0, 1}, {-3.0, 1}}, true}, {"reloading", {{3.0, 1}, {-3.0, 1}, {4.0, 1}}, true},
  };
}

}  // namespace perinox::test
