/// Adds one more body, far away from all others.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <fstream>

#include "variants.hpp"

namespace perinox::invariance {

namespace {

/// Ends sets given by a formula, and the set of all particles, before a body that lies beyond an x.
void end_sets(YAML::Node root, double beyond_x) {
  for (auto set : root["sets"])
    if (set.second["where"])
      set.second["where"] = fmt::format("({}) && x < {}", set.second["where"].as<std::string>(), digits(beyond_x));
  bool any = false;
  const auto rename = [&](YAML::Node entry) {
    if (!entry.IsDefined() || !entry.IsScalar() || entry.as<std::string>() != "all") return;
    entry = "all_that_is_near";
    any = true;
  };
  for (const char* list : {"boundary", "initial_velocity"})
    for (YAML::Node entry : root[list]) rename(entry["set"]);
  for (YAML::Node entry : root["history"])
    for (const char* kind : {"reaction", "displacement", "yielded"}) rename(entry[kind]);
  if (root["fracture"] && root["fracture"]["unbreakable"])
    for (YAML::Node entry : root["fracture"]["unbreakable"]) rename(entry);
  if (any) root["sets"]["all_that_is_near"]["where"] = fmt::format("x < {}", digits(beyond_x));
}

}  // namespace

Variant with_far_body(const DeckText& deck, const Extent& extent, double spacing, bool cloud, Lot& lot,
                      const std::string& prefix) {
  Variant variant{cloud ? "a cloud far away" : "a lattice far away", ""};
  variant.more = true;
  YAML::Node root = YAML::Load(transformed(deck, {}, prefix + (cloud ? "_far_cloud" : "_far_lattice")));
  const bool solid = root["dimension"].as<std::string>() == "3";
  const double h = spacing * lot.between(0.6, 0.9);
  const int across = 4;
  Vector3 corner{};
  corner[0] = extent.max[0] + extent.length() * lot.between(20, 60);
  for (std::size_t c = 1; c < (solid ? 3U : 2U); ++c) corner[c] = extent.min[c] + lot.between(-3, 3) * h;
  end_sets(root, extent.max[0] + 10 * extent.length());
  YAML::Node body;
  body["name"] = "far_body";
  body["material"] = "far_material";
  body["spacing"] = digits(h);
  if (cloud) {
    const std::string file = prefix + "_far_points.csv";
    std::ofstream out(file);
    out << "x,y,z,volume\n";
    for (int k = 0; k < (solid ? across : 1); ++k)
      for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) {
          const double place[3] = {i + lot.between(-0.2, 0.2), j + lot.between(-0.2, 0.2), k + lot.between(-0.2, 0.2)};
          for (std::size_t c = 0; c < 3; ++c) out << digits(c == 2 && !solid ? 0 : corner[c] + place[c] * h) << ',';
          out << digits(std::pow(h, solid ? 3 : 2)) << '\n';
        }
    body["shape"]["file"] = file;
  } else {
    for (std::size_t c = 0; c < (solid ? 3U : 2U); ++c) {
      body["shape"]["box"]["min"].push_back(digits(corner[c]));
      body["shape"]["box"]["max"].push_back(digits(corner[c] + across * h));
    }
  }
  root["body"].push_back(body);
  root["materials"]["far_material"] =
      YAML::Load("{model: elastic, young_modulus: 123, poisson_ratio: 0.21, density: 1.0}");
  YAML::Node held;
  held["set"] = "far_body";
  for (int c = 0; c < (solid ? 3 : 2); ++c) held["displacement"][std::string(1, "xyz"[c])] = 0;
  root["boundary"].push_back(held);
  variant.yaml = YAML::Dump(root);
  return variant;
}

}  // namespace perinox::invariance
