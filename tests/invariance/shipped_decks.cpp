#include "shipped_decks.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

#include "transformation.hpp"

namespace perinox::invariance {

namespace {
const std::string folder = PERINOX_SOURCE_DIR "/inputs";

bool along_an_arc(const YAML::Node& root) {
  return root["steps"]["control"] && root["steps"]["control"].as<std::string>() == "arc-length";
}
}  // namespace

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

DeckText shipped(const std::string& name) {
  YAML::Node root = YAML::LoadFile(folder + "/" + name + ".yaml");
  YAML::Node newton = root["solver"]["newton"];
  newton["tolerance"] = "1e-13";
  newton["update_tolerance"] = "1e-12";
  newton["max_iterations"] = 60;
  newton["forcing"] = "constant";
  root["solver"]["linear"]["tolerance"] = "1e-9";
  if (!root["steps"]["count"]) root["steps"]["count"] = 10;
  if (!root["steps"]["end"]) root["steps"]["end"] = 1;
  return {YAML::Dump(root), folder};
}

int steps_of(const std::string& yaml) {
  const YAML::Node root = YAML::Load(yaml);
  if (along_an_arc(root)) return root["arc_length"]["max_steps"].as<int>(1000);
  return root["steps"]["count"].as<int>();
}

std::string shortened(const std::string& yaml, int steps) {
  YAML::Node root = YAML::Load(yaml);
  if (steps >= steps_of(yaml)) return yaml;
  if (along_an_arc(root)) {
    root["arc_length"]["max_steps"] = steps;
  } else {
    root["steps"]["end"] = digits(root["steps"]["end"].as<double>() * steps / root["steps"]["count"].as<int>());
    root["steps"]["count"] = steps;
  }
  return YAML::Dump(root);
}

bool follows_a_path(const std::string& yaml) { return along_an_arc(YAML::Load(yaml)); }

bool names_particles(const std::string& yaml) {
  const YAML::Node root = YAML::Load(yaml);
  for (const auto& set : root["sets"])
    if (set.second["ids"]) return true;
  return false;
}

}  // namespace perinox::invariance
