#include "elastic_constants.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace perinox::materials {

namespace {

struct Given {
  std::optional<double> bulk, shear, young, poisson, lame;
};

/// The constants k and mu from the first two that are given, in the order bulk, shear, young, poisson, lame.
std::optional<ElasticConstants> from_pair(const Given& g) {
  if (g.bulk && g.shear) return ElasticConstants{*g.bulk, *g.shear};
  if (g.bulk && g.young) return ElasticConstants{*g.bulk, 3 * *g.bulk * *g.young / (9 * *g.bulk - *g.young)};
  if (g.bulk && g.poisson)
    return ElasticConstants{*g.bulk, 3 * *g.bulk * (1 - 2 * *g.poisson) / (2 * (1 + *g.poisson))};
  if (g.bulk && g.lame) return ElasticConstants{*g.bulk, 1.5 * (*g.bulk - *g.lame)};
  if (g.shear && g.young) return ElasticConstants{*g.young * *g.shear / (3 * (3 * *g.shear - *g.young)), *g.shear};
  if (g.shear && g.poisson)
    return ElasticConstants{2 * *g.shear * (1 + *g.poisson) / (3 * (1 - 2 * *g.poisson)), *g.shear};
  if (g.shear && g.lame) return ElasticConstants{*g.lame + 2.0 / 3.0 * *g.shear, *g.shear};
  if (g.young && g.poisson)
    return ElasticConstants{*g.young / (3 * (1 - 2 * *g.poisson)), *g.young / (2 * (1 + *g.poisson))};
  if (g.young && g.lame) {
    const double root = std::sqrt(*g.young * *g.young + 9 * *g.lame * *g.lame + 2 * *g.young * *g.lame);
    return ElasticConstants{(*g.young + 3 * *g.lame + root) / 6, (*g.young - 3 * *g.lame + root) / 4};
  }
  if (g.poisson && g.lame && *g.poisson != 0)
    return ElasticConstants{*g.lame * (1 + *g.poisson) / (3 * *g.poisson),
                            *g.lame * (1 - 2 * *g.poisson) / (2 * *g.poisson)};
  return std::nullopt;
}

deck::Key constant(const char* name, const char* unit, const char* sentence) {
  deck::Key key;
  key.name = name;
  key.type = deck::Type::number;
  key.unit = unit;
  key.sentence = sentence;
  return key;
}

}  // namespace

double ElasticConstants::bulk_of(deck::Dimension dimension) const {
  switch (dimension) {
    case deck::Dimension::plane_strain:
      return bulk + shear / 3;
    case deck::Dimension::plane_stress:
      return 9 * bulk * shear / (3 * bulk + 4 * shear);
    case deck::Dimension::three:
      break;
  }
  return bulk;
}

std::vector<deck::Key> elastic_keys() {
  auto positive = [](deck::Key key) {
    key.minimum = 0;
    key.exclusive_minimum = true;
    return key;
  };
  deck::Key poisson = constant("poisson_ratio", "dimensionless", "Poisson's ratio, between -1 and 0.5.");
  poisson.minimum = -1;
  poisson.exclusive_minimum = true;
  poisson.maximum = 0.4999999;
  deck::Key dilatation;
  dilatation.name = "dilatation";
  dilatation.type = deck::Type::boolean;
  dilatation.fallback = "true";
  dilatation.sentence =
      "false takes the dilatation as zero, so that each bond stands alone (Mitchell's single-bond test).";
  return {positive(constant("bulk_modulus", "stress", "Bulk modulus k (3-D value, in 2-D scenes too).")),
          positive(constant("shear_modulus", "stress", "Shear modulus.")),
          positive(constant("young_modulus", "stress", "Young's modulus.")),
          poisson,
          constant("lame_lambda", "stress", "Lame's first constant."),
          dilatation};
}

ElasticConstants elastic_constants(const deck::Material& material) {
  Given given;
  int count = 0;
  auto take = [&](const char* key, std::optional<double>& slot) {
    if (!material.parameters.has(key)) return;
    slot = material.parameters.at(key).number();
    ++count;
  };
  take("bulk_modulus", given.bulk);
  take("shear_modulus", given.shear);
  take("young_modulus", given.young);
  take("poisson_ratio", given.poisson);
  take("lame_lambda", given.lame);
  if (count < 2)
    deck::refuse(material.location,
                 fmt::format("material {} needs two elastic constants and has {}: give any two of bulk_modulus, "
                             "shear_modulus, young_modulus, poisson_ratio, lame_lambda",
                             material.name, count));
  const auto constants = from_pair(given);
  if (!constants || !(constants->bulk > 0) || !(constants->shear > 0) || !std::isfinite(constants->bulk) ||
      !std::isfinite(constants->shear))
    deck::refuse(material.location,
                 fmt::format("the elastic constants of material {} do not give a positive bulk and shear modulus; "
                             "check that the two belong together",
                             material.name));
  const auto agrees = [](const std::optional<double>& value, double derived, double scale) {
    return !value || std::abs(*value - derived) <= 1e-6 * scale;
  };
  const double lame = constants->bulk - 2.0 / 3.0 * constants->shear;
  if (!agrees(given.bulk, constants->bulk, constants->bulk) ||
      !agrees(given.shear, constants->shear, constants->shear) ||
      !agrees(given.young, constants->young(), constants->young()) || !agrees(given.poisson, constants->poisson(), 1) ||
      !agrees(given.lame, lame, constants->bulk))
    deck::refuse(material.location, fmt::format("the {} elastic constants of material {} contradict each other; give "
                                                "two of them and leave the others out",
                                                count, material.name));
  return *constants;
}

}  // namespace perinox::materials
