#pragma once
/// A deck that reads without an error, ways to break it, and material models like those of the room materials. They are
/// declared here because the deck must not know that room.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"

namespace perinox::deck::fixture {

inline Key number(const std::string& name, const std::string& unit, const std::string& sentence) {
  Key key;
  key.name = name;
  key.unit = unit;
  key.sentence = sentence;
  return key;
}

inline Key stress_choice(const std::string& name, const std::string& sentence) {
  Key key;
  key.name = name;
  key.type = Type::choice;
  key.sentence = sentence;
  key.keys = {number("tension", "stress", "In uniaxial tension."), number("shear", "stress", "In shear.")};
  for (Key& inner : key.keys) {
    inner.minimum = 0;
    inner.exclusive_minimum = true;
  }
  return key;
}

inline std::vector<ModelDeclaration> models() {
  Key dilatation;
  dilatation.name = "dilatation";
  dilatation.type = Type::boolean;
  dilatation.fallback = "true";
  dilatation.sentence = "Keep the volumetric part.";
  std::vector<Key> elastic{
      number("bulk_modulus", "stress", "Bulk modulus."),         number("shear_modulus", "stress", "Shear modulus."),
      number("young_modulus", "stress", "Young's modulus."),     number("poisson_ratio", "-", "Poisson's ratio."),
      number("lame_lambda", "stress", "Lame's first constant."), dilatation};
  Key scaling;
  scaling.name = "yield_scaling";
  scaling.type = Type::word;
  scaling.words = {"discrete", "continuum"};
  scaling.fallback = "discrete";
  scaling.sentence = "How the yield stress becomes the yield value of a family.";
  std::vector<Key> plastic = elastic;
  Key yield = stress_choice("yield_stress", "Yield stress.");
  yield.required = true;
  plastic.push_back(yield);
  plastic.push_back(stress_choice("hardening_modulus", "Slope of the hardening curve."));
  plastic.push_back(scaling);
  return {{"elastic", "Linear peridynamic solid.", elastic},
          {"elastic-plastic",
           "Linear peridynamic solid with plastic flow.",
           plastic,
           {{"plastic_multiplier", "Plastic multiplier.", "length^2*volume/stress", "1", "in plastic scenes"},
            {"equivalent_plastic_strain", "Plastic strain of a tension test.", "-", "1", "in plastic scenes"},
            {"plastic_strain_zz", "Plastic strain out of the plane.", "-", "1", "in plastic 2-D scenes", true}}}};
}

inline const Schema& schema() {
  static const Schema one(models());
  return one;
}

inline const std::string base_deck =
    "title: base\n"
    "dimension: 3\n"
    "body:\n"
    "  - name: block\n"
    "    shape: {box: {min: [0, 0, 0], max: [4, 4, 8]}}\n"
    "    spacing: 1.0\n"
    "    material: steel\n"
    "horizon: {ratio: 3.015}\n"
    "influence: constant\n"
    "quadrature: whole\n"
    "materials:\n"
    "  steel:\n"
    "    model: elastic-plastic\n"
    "    bulk_modulus: 160e3\n"
    "    shear_modulus: 80e3\n"
    "    yield_stress: {tension: 203.1}\n"
    "sets:\n"
    "  foot: {where: \"z < 1.5\"}\n"
    "  head: {where: \"z > 6.5\"}\n"
    "boundary:\n"
    "  - {set: foot, displacement: {x: 0, y: 0, z: 0}}\n"
    "  - set: head\n"
    "    displacement: {z: \"0.3*t\"}\n"
    "steps: {end: 1.0, count: 20}\n"
    "solver:\n"
    "  tangent: matrix-free\n"
    "  newton: {tolerance: 1e-8}\n"
    "output: {every: 1, fields: [displacement, force]}\n"
    "history:\n"
    "  - {name: pull, reaction: head, component: z}\n";

inline const std::string flat_deck =
    "dimension: plane-strain\n"
    "body: [{name: plate, shape: {box: {min: [0, 0], max: [4, 4]}}, spacing: 0.5, material: steel}]\n"
    "horizon: {length: 1.5}\n"
    "cracks: [{segment: {start: [1, 1], end: [2, 1]}}]\n"
    "materials: {steel: {model: elastic, bulk_modulus: 1, shear_modulus: 1}}\n"
    "sets: {left: {box: {min: [0, 0], max: [1, 4]}}}\n"
    "boundary: [{set: left, displacement: {x: 0}}]\n"
    "history: [{name: pull, reaction: left, component: x}]\n";

/// `text` with the first `from` replaced. The test fails if there is none.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "the base deck has no " << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

/// The message of the InputError with which reading `yaml` ends; "" if it reads.
inline std::string message_of(const std::string& yaml, const std::vector<std::string>& overrides = {}) {
  try {
    read_text(yaml, "deck.yaml", schema(), overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace perinox::deck::fixture
