#include "other_scenes.hpp"

#include "scene_text.hpp"

namespace perinox::invariance {

namespace {

std::string sphere(const SceneText& text, const Vector3& center, double radius) {
  return fmt::format("{{sphere: {{center: {}, radius: {}}}}}", text.point(center), digits(radius * text.h));
}

std::string without(const std::string& first, const std::string& second) {
  return fmt::format("{{difference: [{}, {}]}}", first, second);
}

}  // namespace

RandomScene curved_body(Lot& lot) {
  SceneText text(lot, lot.chance(0.3));
  // The lattice has an even number of cells across, so no face of the round surface is exactly along an axis.
  const double radius = (text.solid() ? lot.whole(3, 4) : lot.whole(5, 7)) + lot.between(-0.2, 0.2);
  const std::string whole = sphere(text, {}, radius);
  const std::string shape =
      lot.chance(0.4) ? without(whole, sphere(text, {0.7, 0.3, 0}, lot.between(1.1, 1.6)))
      : text.solid() && lot.chance(0.5)
          ? fmt::format("{{cylinder: {{start: {}, end: {}, radius: {}}}}}", text.point({-2, -1.5, -2.2}),
                        text.point({2, 1.5, 2.2}), digits(2.3 * text.h))
          : whole;
  text.body("a", shape, text.h);
  // A third of it is held, so that an error of the load on one side shows on the other.
  text.add_set("held", "<", -0.37 * radius);
  text.hold("held");
  text.record("held");
  SceneText split = text;
  text.pressure("a", text.plastic ? 0.002 : 0.005);
  RandomScene scene = named("curved body", text);
  scene.round = true;
  // Along an axis the other components of a direction are zero. Whole cells have faces across it, which would be lost.
  const bool along_x = text.quadrature() == "position-aware" && lot.chance(0.5);
  std::string there, back;
  for (int c = 0; c < text.d(); ++c) {
    const double part = along_x ? (c == 0 ? 1 : 0) : lot.sign() * lot.between(0.3, 1);
    there += (c ? ", " : "") + digits(part);
    back += (c ? ", " : "") + digits(-part);
  }
  split.pressure("a", text.plastic ? 0.002 : 0.005, "[" + there + "]");
  split.pressure("a", text.plastic ? 0.002 : 0.005, "[" + back + "]");
  scene.variants.push_back({"pressure split by direction", split.text()});
  return scene;
}

RandomScene slit_body(Lot& lot) {
  SceneText text(lot, lot.chance(0.25));
  const Vector3 size = text.solid() ? Vector3{9, 6, 3} : Vector3{14, 12, 0};
  // A bond across the slit leaves the material by at least the slit's width, or passes its end by more than half a
  // spacing. That is always farther than the 0.3 spacings at which the bond would be kept.
  const double width = lot.between(0.45, 2.2), begin = 0.45 * size[0] + lot.between(0, 0.9);
  const double low = 0.5 * size[1] - width / 2 + lot.between(-0.4, 0.4), middle = low + width / 2;
  const std::string slit = text.box({begin, low, -1}, {size[0] + 1, low + width, size[2] + 1});
  text.body("a", without(text.box({}, size), slit), text.h);
  text.add_set("foot", "<", 2);
  text.sets.push_back(
      fmt::format("lip: {{where: \"x > {} && y > {}\"}}", digits(text.x(size[0] - 3)), digits(text.y(middle))));
  text.hold("foot");
  text.move("lip", 0.03);
  text.record("foot");
  text.record("lip");
  SceneText longer = text;
  // The crack begins in the material, so that it cuts bonds in both.
  text.crack({begin - 1.53, middle + 0.017, 0}, {begin + 0.6, middle + 0.017, 0}, size[2]);
  longer.crack({begin - 1.53, middle + 0.017, 0}, {size[0] + 0.5, middle + 0.017, 0}, size[2]);
  RandomScene scene = named("body with a slit", text);
  Variant variant{"a crack within a slit", longer.text()};
  scene.variants.push_back(variant);
  return scene;
}

RandomScene split_body(Lot& lot) {
  SceneText text(lot, lot.chance(0.4));
  const Vector3 size =
      text.solid() ? Vector3{8, 4, 4} : Vector3{double(lot.whole(10, 14)), double(lot.whole(6, 10)), 0};
  const double cut = lot.whole(3, 6);
  text.add_set("foot", "<", 2);
  text.add_set("head", ">", size[0] - 2);
  text.hold("foot");
  text.move("head", text.plastic ? 0.05 : 0.02);
  text.record("foot");
  text.record("head");
  SceneText two = text;
  text.body("a", text.box({}, size), text.h);
  two.body("a", two.box({}, {cut, size[1], size[2]}), two.h);
  two.body("b", two.box({cut, 0, 0}, size), two.h);
  RandomScene scene = named("body in one piece", text);
  Variant variant{"one body as two", two.text()};
  variant.rows = text.plastic ? Rows::none : Rows::all;  // `yielded` is that of the first body
  scene.variants.push_back(variant);
  return scene;
}

}  // namespace perinox::invariance
