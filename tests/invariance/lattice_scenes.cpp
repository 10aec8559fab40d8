#include "lattice_scenes.hpp"

#include "scene_text.hpp"

namespace perinox::invariance {

namespace {

Vector3 size_of(Lot& lot, bool solid) {
  if (solid) return {double(lot.whole(7, 9)), double(lot.whole(4, 5)), double(lot.whole(4, 5))};
  return {double(lot.whole(11, 15)), double(lot.whole(7, 11)), 0};
}

/// One end is held, the other one is moved or drawn by a force, and the middle is under its weight.
void load(Lot& lot, SceneText& text, const Vector3& size) {
  text.add_set("foot", "<", 2);
  text.add_set("head", ">", size[0] - 2);
  text.hold("foot");
  if (lot.chance(0.7))
    text.move("head", text.plastic ? 0.05 : 0.02);
  else
    text.force("head", text.plastic ? 0.008 : 0.05);
  text.record("foot");
  text.record("head");
}

}  // namespace

RandomScene one_lattice(Lot& lot) {
  SceneText text(lot, lot.chance(0.4));
  const Vector3 size = size_of(lot, text.solid());
  text.body("a", text.box({}, size), text.h);
  load(lot, text, size);
  if (lot.chance(0.5)) text.weigh("a");
  if (lot.chance(0.5)) {
    const double across = lot.whole(3, 4) + lot.between(0.1, 0.4), tilt = lot.between(0.05, 0.3);
    text.crack({across, -1, 0}, {across + tilt, 0.4 * size[1] + lot.between(0, 0.9), 0}, size[2]);
  }
  return named("one lattice", text);
}

RandomScene several_lattices(Lot& lot) {
  SceneText text(lot, lot.chance(0.3));
  const Vector3 size = size_of(lot, text.solid());
  const double first = lot.whole(4, 5), rest = size[0] - first;
  const double finer = text.solid() ? lot.one_of<double>({1, 0.75, 0.8}) : lot.one_of<double>({1, 0.5, 0.7});
  text.body("a", text.box({}, {first, size[1], size[2]}), text.h);
  const double up = lot.between(-0.45, 0.45), aside = text.solid() ? lot.between(-0.45, 0.45) : 0;
  text.body("b", text.box({first, up, aside}, {first + rest, up + size[1], aside + size[2]}), finer * text.h,
            lot.one_of<std::string>({"one", "two"}));
  text.add_set("foot", "<", 2);
  text.add_set("head", ">", size[0] - 1.9 + 0.013);
  text.hold("foot");
  text.move("head", 0.02);
  text.record("foot");
  text.record("head");
  text.record("b");
  if (lot.chance(0.5)) text.weigh("b");
  return named("several lattices", text);
}

RandomScene bodies_apart(Lot& lot) {
  SceneText text(lot, lot.chance(0.2));
  const Vector3 size = text.solid() ? Vector3{5, 4, 4} : Vector3{double(lot.whole(6, 9)), double(lot.whole(6, 9)), 0};
  const double gap = lot.chance(0.7) ? lot.between(0.12, 0.48) : lot.between(1, 3);
  const double up = lot.one_of<double>({0, 0, lot.between(-0.4, 0.4)});
  text.extra = "bond_bodies: false\n";
  text.body("a", text.box({}, size), text.h);
  text.add_set("foot", "<", 2);
  text.hold("foot");
  text.pressure("a", text.plastic ? 0.001 : 0.01);
  text.record("foot");
  const SceneText alone = text;
  text.body("b", text.box({size[0] + gap, up, up}, {2 * size[0] + gap, up + size[1], up + size[2]}),
            text.h * lot.one_of<double>({1, 1, 0.8}), "two");
  text.add_set("other_foot", ">", 2 * size[0] + gap - 1.95);
  text.hold("other_foot");
  text.pressure("b", text.plastic ? 0.002 : 0.02);
  RandomScene scene = named("bodies apart", alone);
  Variant both{"another body beside it", text.text()};
  both.rows = Rows::none;
  both.more = true;
  scene.variants.push_back(both);
  return scene;
}

RandomScene box_that_cuts_cells(Lot& lot) {
  SceneText text(lot, lot.chance(0.4));
  Vector3 size = size_of(lot, text.solid());
  // Exactly half a cell is included, because people write it.
  for (int c = 1; c < text.d(); ++c)
    size[static_cast<std::size_t>(c)] += lot.chance(0.3) ? 0.5 : lot.sign() * lot.between(0.05, 0.45);
  text.body("a", text.box({}, size), text.h);
  load(lot, text, size);
  text.weigh("a");
  RandomScene scene = named("box that cuts cells", text);
  const double cut = size[1] * lot.between(0.3, 0.7);
  const std::string halves =
      fmt::format("{{union: [{}, {}]}}", text.box({}, {size[0], cut, size[2]}), text.box({0, cut, 0}, size));
  SceneText other = text;
  other.bodies.clear();
  other.body("a", halves, text.h);
  scene.variants.push_back({"described as a union", other.text()});
  other.bodies.clear();
  const std::string beyond = text.box({-3, size[1], -3}, {size[0] + 3, size[1] + 0.3, size[2] + 3});
  other.body("a", fmt::format("{{difference: [{}, {}]}}", text.box({}, size), beyond), text.h);
  scene.variants.push_back({"described as a difference", other.text()});
  return scene;
}

}  // namespace perinox::invariance
