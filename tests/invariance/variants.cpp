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

/// Replaces the load parameter t by `word` in every formula below a node.
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

std::optional<Variant> reordered(const DeckText& deck) {
  YAML::Node root = YAML::Load(deck.yaml);
  if (root["body"].size() < 2) return std::nullopt;
  if (root["overlap"] && root["overlap"].as<std::string>() == "later-wins") return std::nullopt;  // the order is meant
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
