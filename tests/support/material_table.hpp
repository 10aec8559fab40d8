#pragma once
/// Every material and the states it is tested in. A new material needs one row in materials() and nothing else.
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "perinox/materials/elastic.hpp"
#include "perinox/materials/elastic_plastic.hpp"
#include "perinox/materials/plane_plastic.hpp"
#include "support/families.hpp"

namespace perinox::test {

/// Steel-like constants in units that make stresses of order 100 (MPa): Mitchell's section 8.
constexpr double bulk = 67.5e3;
constexpr double shear = 25.9e3;
constexpr double yield_shear = 117.26;                // about 203.1/sqrt(3)
constexpr double yield_strain = yield_shear / shear;  // shear strain at first yield
constexpr double hardening_shear = 0.1 * shear;       // strong enough to tell from perfect plasticity

/// What an elastic-plastic row promises beyond its potential.
struct YieldSurface {
  double stress = 0;              ///< tau_y
  double hardening = 0;           ///< d tau_y/d gamma_p
  bool continuum = false;         ///< beta from the continuum weighted volume
  bool volume_preserving = true;  ///< e_p is deviatoric
  bool plane = false;             ///< part of the yield value is out of the plane
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
                                                                         surface.continuum, surface.volume_preserving});
    };
  };
  const auto plane = [](const YieldSurface& surface, deck::Dimension dimension) {
    return [=] {
      return std::make_unique<materials::PlanePlastic>(
          ElasticPlastic::Parameters{bulk, shear, surface.stress, surface.hardening, false, true}, dimension);
    };
  };
  const YieldSurface flat{yield_shear, 0, false, true, true};
  const YieldSurface flat_hardening{yield_shear, hardening_shear, false, true, true};
  const YieldSurface perfect{yield_shear, 0, false, true};
  const YieldSurface hardening{yield_shear, hardening_shear, false, true};
  const YieldSurface continuum{yield_shear, 0, true, true};
  const YieldSurface continuum_hardening{yield_shear, hardening_shear, true, true};
  const YieldSurface bondwise{yield_shear, hardening_shear, false, false};
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
  };
}

/// A load path in effective shear, in units of the yield strain; the last entry is the state under test, those before
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
