#include "cloud_scenes.hpp"

#include <fstream>

#include "scene_text.hpp"

namespace perinox::invariance {

namespace {

struct CloudPoint {
  Vector3 place;
  double volume;
};

/// Adds a cloud as a body of the text. The points are in spacings from the origin.
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

/// Cells of a lattice whose centres are in a box. The lattice is turned by an angle about z (and, in 3-D, about another
/// axis too).
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
  text.add_set("foot", "<", 2.011);
  text.add_set("head", ">", size[0] - 2.011);
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
