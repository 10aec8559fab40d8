#include "rewriting.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "perinox/deck/schema.hpp"
#include "perinox/materials/material.hpp"

namespace perinox::invariance {

namespace {

using deck::Key;
using deck::Type;

class Rewriting {
 public:
  Rewriting(const DeckText& deck, const Transformation& change, std::string prefix)
      : root_(YAML::Load(deck.yaml)),
        folder_(deck.folder),
        change_(change),
        prefix_(std::move(prefix)),
        dimension_(root_["dimension"].as<std::string>() == "3" ? 3 : 2) {}

  std::string text() {
    if (!change_.along_axes()) root_.remove("history");
    return YAML::Dump(value(root_, schema_.root()));
  }

 private:
  YAML::Node value(const YAML::Node& node, const Key& named_key) {
    const Key& key = schema_.structure(named_key);
    switch (key.type) {
      case Type::number:
        return YAML::Node(digits(node.as<double>() * change_.factor(key.unit, dimension_)));
      case Type::expression:
        return YAML::Node(scaled(change_.formula(node.as<std::string>()), change_.factor(key.unit, dimension_)));
      case Type::point:
        return point(node, named_key);
      case Type::path:
        return YAML::Node(file(node.as<std::string>()));
      case Type::list: {
        YAML::Node out(YAML::NodeType::Sequence);
        for (const YAML::Node& item : node) out.push_back(value(item, key.element.front()));
        return out;
      }
      case Type::named: {
        YAML::Node out(YAML::NodeType::Map);
        for (const auto& entry : node) out[entry.first.as<std::string>()] = value(entry.second, key.element.front());
        return out;
      }
      case Type::map:
      case Type::choice:
        return map(node, key, named_key.name);
      default:
        return YAML::Clone(node);
    }
  }

  const Key& child(const YAML::Node& node, const Key& key, const std::string& name) const {
    for (const Key& candidate : key.keys)
      if (candidate.name == name) return candidate;
    if (key.picks_model)
      for (const Key& candidate : schema_.model(node["model"].as<std::string>())->keys)
        if (candidate.name == name) return candidate;
    throw std::logic_error("the schema has no key " + name);
  }

  YAML::Node map(const YAML::Node& node, const Key& key, const std::string& name) {
    if (is_vector(node, key)) return vector(node, key);
    if (node["plate_with_hole"] && dimension_ == 3 && change_.axis(2) != 2) return map(drilled(node), key, name);
    YAML::Node out(YAML::NodeType::Map);
    for (const auto& entry : node) {
      const auto word = entry.first.as<std::string>();
      out[word] = value(entry.second, child(node, key, word));
    }
    if (node["component"]) component(out);
    if (name == "box" || name == "plate_with_hole") sort_corners(out);
    return out;
  }

  /// The hole of plate_with_hole runs along z in any frame; a cylinder that is taken out runs along any axis.
  static YAML::Node drilled(const YAML::Node& shape) {
    const YAML::Node& plate = shape["plate_with_hole"];
    YAML::Node out, box, hole;
    box["box"]["min"] = plate["min"];
    box["box"]["max"] = plate["max"];
    const double low = plate["min"][2].as<double>(), high = plate["max"][2].as<double>();
    for (const auto& [end, z] : {std::pair("start", 2 * low - high), std::pair("end", 2 * high - low)})
      for (const std::string& part :
           {plate["center"][0].as<std::string>(), plate["center"][1].as<std::string>(), digits(z)})
        hole["cylinder"][end].push_back(part);
    hole["cylinder"]["radius"] = plate["radius"];
    out["difference"].push_back(box);
    out["difference"].push_back(hole);
    return out;
  }

  /// True for a map of components x, y, z, each a formula.
  bool is_vector(const YAML::Node& node, const Key& key) const {
    if (!node["x"] && !node["y"] && !node["z"]) return false;
    return std::any_of(key.keys.begin(), key.keys.end(),
                       [](const Key& k) { return k.name == "x" && k.type == Type::expression; });
  }
  YAML::Node vector(const YAML::Node& node, const Key& key) {
    std::array<std::string, 3> old, made;
    const double factor = change_.factor(child(node, key, "x").unit, dimension_);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string name(1, "xyz"[k]);
      if (node[name]) old[k] = change_.formula(node[name].as<std::string>());
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double part = change_.turn[i][k] * factor;
        if (part == 0 || (static_cast<int>(k) >= dimension_)) continue;
        if (old[k].empty() && change_.along_axes()) continue;
        if (old[k].empty()) throw std::logic_error("a turned vector needs all its components");
        if (!made[i].empty()) made[i] += " + ";
        made[i] += scaled(old[k], part);
      }
    YAML::Node out(YAML::NodeType::Map);
    for (std::size_t i = 0; i < 3; ++i)
      if (!made[i].empty()) out[std::string(1, "xyz"[i])] = made[i];
    return out;
  }

  static std::string scaled(const std::string& formula, double factor) {
    return factor == 1 ? formula : fmt::format("({})*({})", digits(factor), formula);
  }

  YAML::Node point(const YAML::Node& node, const Key& key) const {
    Vector3 old{};
    for (std::size_t k = 0; k < node.size(); ++k) old[k] = node[k].as<double>();
    Vector3 made = change_.direction(old);
    const bool edge = key.name == "edge1" || key.name == "edge2";
    if (key.unit == "length" && !edge)
      made = change_.place(old);
    else if (key.unit == "length")
      for (double& part : made) part *= change_.length;
    YAML::Node out(YAML::NodeType::Sequence);
    for (std::size_t k = 0; k < node.size(); ++k) out.push_back(digits(made[k]));
    return out;
  }

  void sort_corners(YAML::Node box) const {
    if (!change_.along_axes()) throw std::logic_error("a box stays a box only along the axes");
    for (std::size_t k = 0; k < box["min"].size(); ++k) {
      const double a = box["min"][k].as<double>(), b = box["max"][k].as<double>();
      box["min"][k] = digits(std::min(a, b));
      box["max"][k] = digits(std::max(a, b));
    }
  }

  /// Rewrites the component of a history entry, or of arc_length.until with its displacement.
  void component(YAML::Node entry) const {
    const auto old = static_cast<std::size_t>(entry["component"].as<std::string>()[0] - 'x');
    entry["component"] = std::string(1, "xyz"[change_.axis(old)]);
    if (entry["displacement"] && entry["set"])
      entry["displacement"] = digits(entry["displacement"].as<double>() * change_.sign(old));
  }

  /// Rewrites the file of a cloud, of a table of displacements or of hardening.
  std::string file(const std::string& name) {
    const std::string old = std::filesystem::path(name).is_absolute() ? name : folder_ + "/" + name;
    const std::string made = fmt::format("{}_{}.csv", prefix_, files_++);
    std::ifstream in(old);
    std::ofstream out(made);
    std::string line;
    std::vector<std::string> columns;
    while (std::getline(in, line)) {
      if (line.empty() || line[0] == '#') continue;
      std::vector<std::string> fields;
      std::istringstream parts(line);
      for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
      if (columns.empty()) {
        columns = fields;
        out << line << '\n';
        continue;
      }
      out << row(columns, fields) << '\n';
    }
    return made;
  }

  std::string row(const std::vector<std::string>& columns, const std::vector<std::string>& fields) const {
    std::map<std::string, double> values;
    for (std::size_t k = 0; k < columns.size(); ++k) values[columns[k]] = std::stod(fields[k]);
    if (values.count("x")) {
      const Vector3 x = change_.place({values["x"], values["y"], values["z"]});
      values["x"] = x[0], values["y"] = x[1], values["z"] = x[2];
    }
    if (values.count("ux")) {
      const Vector3 u = change_.direction({values["ux"], values["uy"], values["uz"]});
      values["ux"] = u[0] * change_.length, values["uy"] = u[1] * change_.length, values["uz"] = u[2] * change_.length;
    }
    if (values.count("volume")) values["volume"] *= std::pow(change_.length, dimension_);
    if (values.count("yield_stress")) values["yield_stress"] *= change_.stress;
    std::string out;
    for (const std::string& column : columns) out += (out.empty() ? "" : ",") + digits(values[column]);
    return out;
  }

  deck::Schema schema_ = materials::full_schema();
  YAML::Node root_;
  std::string folder_;
  const Transformation& change_;
  std::string prefix_;
  int dimension_;
  int files_ = 0;
};

}  // namespace

std::string transformed(const DeckText& deck, const Transformation& change, const std::string& prefix) {
  return Rewriting(deck, change, prefix).text();
}

}  // namespace perinox::invariance
