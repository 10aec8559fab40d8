#pragma once
/// A deck in the making: what is common to all random scenes, and its text.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "random_scenes.hpp"

namespace perinox::invariance {

class SceneText {
 public:
  SceneText(Lot& lot, bool solid);

  int d() const { return solid_ ? 3 : 2; }
  bool solid() const { return solid_; }
  const std::string& quadrature() const { return quadrature_; }
  double h = 1;         ///< the largest spacing
  Vector3 origin{};     ///< of the first body
  std::string extra{};  ///< more keys of the deck
  std::vector<std::string> bodies, sets, boundary, cracks;

  /// A point given in spacings from the origin.
  std::string point(const Vector3& cells) const;
  std::string box(const Vector3& min, const Vector3& max) const;
  double x(double cells) const { return origin[0] + cells * h; }
  double y(double cells) const { return origin[1] + cells * h; }
  /// Adds a set named `name` of the particles below ("<") or above (">") a place in x.
  void add_set(const std::string& name, const char* side, double cells);

  void body(const std::string& name, const std::string& shape, double spacing, const std::string& material = "one");
  /// Holds all components.
  void hold(const std::string& set);
  /// Moves all components by t times a random strain of `size` spacings.
  void move(const std::string& set, double size);
  void force(const std::string& set, double stress);
  /// Adds a body force that varies over the body, on all particles of a set.
  void weigh(const std::string& set);
  void pressure(const std::string& set, double stress, const std::string& facing = "");
  /// Adds a crack: a straight cut in the plane, or a rectangle that stands on it through the whole thickness. In
  /// spacings.
  void crack(const Vector3& start, const Vector3& end, double thickness);
  /// Records reactions and movements of a set, all components.
  void record(const std::string& set);

  bool plastic = false, small = true;
  int steps = 1;
  std::string text() const;

 private:
  std::string components(const Vector3& values, const std::string& formula) const;
  std::string material(Lot& lot, bool plastic) const;

  Lot& lot_;
  bool solid_;
  double modulus_;
  std::string one_, two_;
  std::string dimension_, quadrature_, influence_;
  double ratio_;
  std::vector<std::string> history_;
};

/// The scene of a text that is complete.
RandomScene named(const std::string& name, const SceneText& text);

}  // namespace perinox::invariance
