#include "other_scenes.hpp"

#include <fstream>

#include "scene_text.hpp"

namespace perinox::invariance {

namespace {

std::string sphere(const SceneText& text, const Vector3& center, double radius) {
  return fmt::format("{{sphere: {{center: {}, radius: {}}}}}", text.point(center), digits(radius * text.h));
}

std::string without(const std::string& first, const std::string& second) {
  return fmt::format("{{difference: [{}, {}]}}", first, second);
}

std::string beyond_x(const SceneText& text, const char* sign, double cells) {
  return fmt::format("{{where: \"x {} {}\"}}", sign, digits(text.x(cells)));
}

}  // namespace

RandomScene curved_body(Lot& lot) {
  SceneText text(lot, lot.chance(0.3));
  // An even number of cells across: no face of the round surface is exactly along an axis.
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
  text.sets.push_back("held: " + beyond_x(text, "<", -0.37 * radius));
  text.hold("held");
  text.record("held");
  SceneText split = text;
  text.pressure("a", text.plastic ? 0.002 : 0.005);
  RandomScene scene = named("curved body", text);
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
  // A bond across the slit leaves the material by its width at least, or passes its end by more than half a spacing:
  // always farther than the 0.3 spacings at which it would be kept.
  const double width = lot.between(0.45, 2.2), begin = 0.45 * size[0] + lot.between(0, 0.9);
  const double low = 0.5 * size[1] - width / 2 + lot.between(-0.4, 0.4), middle = low + width / 2;
  const std::string slit = text.box({begin, low, -1}, {size[0] + 1, low + width, size[2] + 1});
  text.body("a", without(text.box({}, size), slit), text.h);
  text.sets.push_back("foot: " + beyond_x(text, "<", 2));
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
  text.sets.push_back("foot: " + beyond_x(text, "<", 2));
  text.sets.push_back("head: " + beyond_x(text, ">", size[0] - 2));
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
  variant.rows = text.plastic ? Rows::none : Rows::all;  // `yielded` is of the first body
  scene.variants.push_back(variant);
  return scene;
}

namespace {

struct CloudPoint {
  Vector3 place;
  double volume;
};

/// As a body of the text. The points are in spacings from the origin.
void add_cloud(SceneText& text, const std::string& name, const std::string& folder,
               const std::vector<CloudPoint>& points, const std::string& material = "one") {
  const std::string file = folder + "/" + name + ".csv";
  std::ofstream out(file);
  out << "x,y,z,volume\n";
  for (const CloudPoint& point : points) {
    for (std::size_t c = 0; c < 3; ++c) out << digits(text.origin[c] + point.place[c] * text.h) << ',';
    out << digits(point.volume * std::pow(text.h, text.d())) << '\n';
  }
  text.body(name, "{file: " + file + "}", text.h, material);
}

std::vector<CloudPoint> jittered(Lot& lot, bool solid, const Vector3& from, const Vector3& size, double jitter) {
  std::vector<CloudPoint> points;
  for (int k = 0; k < (solid ? int(size[2]) : 1); ++k)
    for (int j = 0; j < int(size[1]); ++j)
      for (int i = 0; i < int(size[0]); ++i) {
        const auto near = [&](double center) { return center + lot.between(-jitter, jitter); };
        CloudPoint point{{near(from[0] + i + 0.5), near(from[1] + j + 0.5), solid ? near(from[2] + k + 0.5) : 0},
                         1 + 2 * lot.between(-jitter, jitter)};
        points.push_back(point);
      }
  return points;
}

/// Cells of a lattice turned by an angle about z (and, in 3-D, about another axis too), whose centres are in a box.
std::vector<CloudPoint> turned(Lot& lot, bool solid, const Vector3& size) {
  const double angle = lot.one_of<double>({0, std::acos(-1.0) / 4, lot.between(0.1, 1.4)});
  const Vector3 axis = solid && lot.chance(0.5) ? Vector3{1, 0.3, 2} : Vector3{0, 0, 1};
  const auto turn = rotation(axis, angle);
  const int reach = int(size[0]);
  std::vector<CloudPoint> points;
  for (int k = solid ? -reach : 0; k <= (solid ? reach : 0); ++k)
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) {
        CloudPoint point{{}, 1};
        bool inside = true;
        for (std::size_t c = 0; c < (solid ? 3U : 2U); ++c) {
          point.place[c] = size[c] / 2 + turn[c][0] * i + turn[c][1] * j + turn[c][2] * k;
          inside = inside && point.place[c] > 0.0137 && point.place[c] < size[c] - 0.0137;
        }
        if (inside) points.push_back(point);
      }
  return points;
}

RandomScene loaded_cloud(Lot& lot, SceneText& text, const std::string& name, const Vector3& size) {
  text.sets.push_back("foot: " + beyond_x(text, "<", 2.011));
  text.sets.push_back("head: " + beyond_x(text, ">", size[0] - 2.011));
  text.hold("foot");
  if (lot.chance(0.7))
    text.move("head", text.plastic ? 0.05 : 0.02);
  else
    text.force("head", text.plastic ? 0.008 : 0.05);
  if (lot.chance(0.5)) text.weigh("a");
  text.record("foot");
  text.record("head");
  RandomScene scene = named(name, text);
  scene.clouds = true;
  return scene;
}

Vector3 cloud_size(Lot& lot, bool solid) {
  if (solid) return {double(lot.whole(7, 9)), double(lot.whole(4, 5)), 4};
  return {double(lot.whole(11, 14)), double(lot.whole(7, 10)), 0};
}

}  // namespace

RandomScene jittered_cloud(Lot& lot, const std::string& folder) {
  SceneText text(lot, lot.chance(0.5));
  const Vector3 size = cloud_size(lot, text.solid());
  add_cloud(text, "a", folder, jittered(lot, text.solid(), {}, size, lot.between(0.02, 0.2)));
  return loaded_cloud(lot, text, "jittered cloud", size);
}

RandomScene turned_cloud(Lot& lot, const std::string& folder) {
  SceneText text(lot, lot.chance(0.5));
  const Vector3 size = cloud_size(lot, text.solid());
  add_cloud(text, "a", folder, turned(lot, text.solid(), size));
  return loaded_cloud(lot, text, "cloud of a turned lattice", size);
}

RandomScene cloud_and_lattice(Lot& lot, const std::string& folder) {
  SceneText text(lot, lot.chance(0.3));
  const Vector3 size = cloud_size(lot, text.solid());
  const double first = 5;
  text.body("b", text.box({}, {first, size[1], size[2]}), text.h, lot.one_of<std::string>({"one", "two"}));
  add_cloud(text, "a", folder,
            jittered(lot, text.solid(), {first, 0, 0}, {size[0] - first, size[1], size[2]},
                     lot.one_of<double>({0, lot.between(0.02, 0.2)})));
  RandomScene scene = loaded_cloud(lot, text, "cloud and lattice", size);
  scene.clouds = false;
  return scene;
}

}  // namespace perinox::invariance
