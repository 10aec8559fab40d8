#pragma once
/// Scenes drawn by lot, each from its number alone.
#include <string>
#include <vector>

#include "answer.hpp"
#include "lot.hpp"

namespace perinox::invariance {

/// The scene described in another way, or with something that must not matter.
struct Variant {
  std::string kind;
  std::string yaml;
  Transformation change{};
  Rows rows = Rows::all;
  bool more = false;  ///< it has particles that the scene has not
};

struct RandomScene {
  std::string name;
  std::string yaml;
  bool elastic = true;  ///< the answer does not depend on the way there
  bool small = true;    ///< linear, if elastic
  bool round = false;   ///< its surface is integrated line by line, along one of the axes
  bool clouds = false;  ///< all bodies are clouds and all supports hold every component, so any rotation will do
  std::vector<Variant> variants{};  ///< variants for this scene alone
};

/// Number of scenes, and of the sorts of scenes, which take turns.
constexpr int random_scene_count = 200;
constexpr int random_scene_sorts = 10;

/// Draws the scene of a number. Files that it needs are written into `folder`.
///
/// The model has ties of its own, at which an answer may jump: a neighbour at the horizon to 1e-6 of it, a bond that
/// leaves the material by 0.3 spacings, a crack's tip on a bond, a bound of a set on a particle. Places are drawn so
/// that nothing comes near such a tie, except where the scene is there to test what happens at it.
RandomScene random_scene(int number, const std::string& folder);

}  // namespace perinox::invariance
