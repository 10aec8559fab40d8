#include "variants.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <numeric>

namespace perinox::invariance {

namespace {

Variant changed(const std::string& kind, const DeckText& deck, Transformation change, const std::string& prefix) {
  Variant variant{kind, "", std::move(change)};
  std::string file = kind;
  std::replace(file.begin(), file.end(), ' ', '_');
  variant.yaml = transformed(deck, variant.change, prefix + "_" + file);
  return variant;
}

YAML::Node reversed_list(const YAML::Node& list) {
  YAML::Node out(YAML::NodeType::Sequence);
  for (std::size_t k = list.size(); k-- > 0;) out.push_back(YAML::Clone(list[k]));
  return out;
}

YAML::Node reversed_map(const YAML::Node& map) {
  std::vector<std::pair<std::string, YAML::Node>> items;
  for (const auto& entry : map) items.emplace_back(entry.first.as<std::string>(), entry.second);
  YAML::Node out(YAML::NodeType::Map);
  for (std::size_t k = items.size(); k-- > 0;) out[items[k].first] = items[k].second;
  return out;
}

/// Puts `word` for the load parameter t in every formula below a node.
void replace_load_parameter(YAML::Node node, const std::string& word) {
  if (node.IsScalar()) {
    const auto text = node.as<std::string>();
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
      const auto in_name = [&](std::size_t k) {
        return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) || text[k] == '_');
      };
      const bool alone = text[at] == 't' && !in_name(at + 1) && (at == 0 || !in_name(at - 1));
      out += alone ? word : std::string(1, text[at]);
    }
    node = out;
    return;
  }
  for (auto entry : node) {
    if (node.IsMap() && entry.first.as<std::string>() == "set") continue;
    YAML::Node below = node.IsMap() ? YAML::Node(entry.second) : YAML::Node(entry);
    replace_load_parameter(below, word);
  }
}

/// Sets by a formula, and the set of all particles, end before a body that is beyond an x.
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

double Extent::length() const {
  double longest = 0;
  for (std::size_t c = 0; c < 3; ++c) longest = std::max(longest, max[c] - min[c]);
  return longest;
}

Extent extent_of(const Answer& answer) {
  Extent extent;
  for (std::size_t k = 0; k < answer.place.size(); ++k) {
    extent.min[k % 3] = k < 3 ? answer.place[k] : std::min(extent.min[k % 3], answer.place[k]);
    extent.max[k % 3] = k < 3 ? answer.place[k] : std::max(extent.max[k % 3], answer.place[k]);
  }
  return extent;
}

std::vector<Variant> frames(const DeckText& deck, const Extent& extent, int dimension, Lot& lot,
                            const std::string& prefix) {
  const int d = dimension;
  std::vector<Variant> all;
  Transformation moved;
  for (int c = 0; c < d; ++c)
    moved.shift[static_cast<std::size_t>(c)] = lot.sign() * 1e5 * extent.length() * lot.between(0.5, 1);
  all.push_back(changed("moved by 1e5 body lengths", deck, moved, prefix));

  Transformation mirrored;
  const auto axis = static_cast<std::size_t>(lot.whole(0, d - 1));
  mirrored.turn[axis][axis] = -1;
  mirrored.shift[axis] = extent.min[axis] + extent.max[axis];  // on to itself
  all.push_back(changed("mirrored", deck, mirrored, prefix));

  Transformation exchanged;
  std::vector<std::size_t> order(static_cast<std::size_t>(d));
  std::iota(order.begin(), order.end(), std::size_t{0});
  const int turns = lot.whole(1, d - 1);
  std::rotate(order.begin(), order.begin() + turns, order.end());
  for (std::size_t k = 0; k < order.size(); ++k) {
    exchanged.turn[k].fill(0);
    exchanged.turn[k][order[k]] = lot.sign();
  }
  all.push_back(changed("axes exchanged", deck, exchanged, prefix));

  Transformation lengths;
  lengths.length = std::pow(10, lot.between(-4, 4));
  all.push_back(changed("unit of length", deck, lengths, prefix));
  Transformation stresses;
  stresses.stress = std::pow(10, lot.between(-7, 7));
  all.push_back(changed("unit of stress", deck, stresses, prefix));
  return all;
}

Variant turned(const DeckText& deck, int dimension, Lot& lot, const std::string& prefix) {
  Transformation change;
  const bool solid = dimension == 3;
  const Vector3 axis{solid ? lot.between(-1, 1) : 0, solid ? lot.between(-1, 1) : 0, 1};
  change.turn = rotation(axis, lot.between(0.1, 6.2));
  if (!solid) change.turn[2] = {0, 0, 1}, change.turn[0][2] = change.turn[1][2] = 0;
  Variant variant = changed("turned by any angle", deck, change, prefix);
  variant.rows = Rows::none;
  return variant;
}

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

std::optional<Variant> reordered(const DeckText& deck) {
  YAML::Node root = YAML::Load(deck.yaml);
  if (root["body"].size() < 2) return std::nullopt;
  root["body"] = reversed_list(root["body"]);
  root["materials"] = reversed_map(root["materials"]);
  if (root["sets"]) root["sets"] = reversed_map(root["sets"]);
  return Variant{"bodies in another order", YAML::Dump(root)};
}

std::optional<Variant> permuted(const DeckText& deck, Lot& lot, const std::string& prefix) {
  YAML::Node root = YAML::Load(transformed(deck, {}, prefix + "_permuted"));
  bool any = false;
  for (YAML::Node body : root["body"]) {
    if (!body["shape"]["file"]) continue;
    any = true;
    const auto file = body["shape"]["file"].as<std::string>();
    std::ifstream in(file);
    std::string header, line;
    std::vector<std::string> rows;
    std::getline(in, header);
    while (std::getline(in, line)) rows.push_back(line);
    in.close();
    for (std::size_t k = rows.size(); k > 1; --k)
      std::swap(rows[k - 1], rows[static_cast<std::size_t>(lot.whole(0, static_cast<int>(k) - 1))]);
    std::ofstream out(file);
    out << header << '\n';
    for (const std::string& row : rows) out << row << '\n';
  }
  if (!any) return std::nullopt;
  return Variant{"rows of clouds permuted", YAML::Dump(root)};
}

Variant with_more_steps(const DeckText& deck, bool linear) {
  YAML::Node root = YAML::Load(deck.yaml);
  root["steps"]["count"] = 2 * root["steps"]["count"].as<int>();
  Variant variant{"twice the steps", YAML::Dump(root)};
  variant.rows = linear ? Rows::last : Rows::none;
  return variant;
}

Variant through_zero(const DeckText& deck) {
  YAML::Node root = YAML::Load(deck.yaml);
  const auto end = root["steps"]["end"].as<double>();
  root["steps"]["end"] = 3 * end;
  root["steps"]["count"] = 3 * root["steps"]["count"].as<int>();
  replace_load_parameter(root["boundary"], fmt::format("(t<{0} ? t : (t<2*{0} ? 2*{0}-t : t-2*{0}))", end));
  Variant variant{"unloaded to zero and loaded again", YAML::Dump(root)};
  variant.rows = Rows::last;
  return variant;
}

}  // namespace perinox::invariance
