#pragma once
/// A study on a deck in a folder of its own, and the sentence of a refusal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "perinox/core/error.hpp"
#include "perinox/study/study.hpp"

namespace perinox::study::fixture {

/// An empty folder that is gone when the test ends.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "perinox_study_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
    path_ = pattern;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ + "/" + name, std::ios::binary) << text;
  }

 private:
  std::string path_;
};

inline const std::string base_study =
    "title: base\n"
    "deck: flat.yaml\n"
    "set: {solver.newton.tolerance: 1e-10}\n"
    "sweep:\n"
    "  - {key: quadrature, values: [whole, position-aware]}\n"
    "  - {key: body.0.spacing, values: [1, 0.5]}\n"
    "measures:\n"
    "  - {name: F, history: pull, exact: \"2*spacing\"}\n"
    "  - {name: u, field: displacement, solution: {x: \"0.1*x*t\"}, where: \"x > spacing\"}\n";

inline const std::string flat_deck =
    "dimension: plane-strain\n"
    "body: [{name: plate, shape: {box: {min: [0, 0], max: [3, 3]}}, spacing: 1, material: steel}]\n"
    "horizon: {ratio: 2.015}\n"
    "materials: {steel: {model: elastic, bulk_modulus: 160e3, shear_modulus: 80e3}}\n"
    "sets: {left: {where: \"x < 1\"}}\n"
    "boundary: [{set: left, displacement: {x: 0, y: 0}}]\n"
    "history: [{name: pull, reaction: left, component: x}]\n";

/// `text` with the first `from` replaced. The test fails if there is none.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "the text has no " << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

/// The message of the InputError with which `work` ends; "" if there is none.
template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace perinox::study::fixture
