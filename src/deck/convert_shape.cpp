#include <fmt/format.h>

#include <cmath>

#include "convert.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::deck {
namespace {

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

std::vector<Shape> convert_parts(const Value& list, Dimension dimension, const std::string& name) {
  std::vector<Shape> parts;
  for (const Value& item : list.items()) {
    parts.push_back(convert_shape(item, dimension));
    if (std::holds_alternative<CloudFile>(parts.back().form)) {
      refuse(item.location(), fmt::format("a point cloud cannot be part of a {}; give it a body of its own", name));
    }
  }
  return parts;
}

void refuse_same_ends(const Point& start, const Point& end, const Value& at, const std::string& name) {
  if (start == end) refuse(at.location(), fmt::format("start and end of the {} are the same point; move one", name));
}

}  // namespace

Point convert_point(const Value& value, Dimension dimension, const std::string& name, bool third_allowed) {
  Point point{0, 0, 0};
  const auto& items = value.items();
  for (std::size_t i = 0; i < items.size(); ++i) point[i] = items[i].number();
  if (dimension == Dimension::three && items.size() < 3) {
    refuse(value.location(), fmt::format("{} needs 3 numbers in a deck with dimension: 3, but has 2", name));
  }
  if (dimension != Dimension::three && point[2] != 0 && !third_allowed) {
    refuse(items[2].location(), fmt::format("the third entry of {} is {} but must be 0 in 2-D; leave it out", name,
                                            format_number(point[2])));
  }
  return point;
}

void refuse_empty_box(const Point& min, const Point& max, Dimension dimension, const Location& where,
                      const std::string& name) {
  const char* axes = "xyz";
  for (std::size_t i = 0; i < static_cast<std::size_t>(unknowns(dimension)); ++i) {
    if (max[i] > min[i]) continue;
    refuse(where, fmt::format("max of the {} must be greater than min in {}, but {} is not greater than {}", name,
                              axes[i], format_number(max[i]), format_number(min[i])));
  }
}

Shape convert_shape(const Value& value, Dimension dimension) {
  Shape shape;
  shape.location = value.location();
  const auto& [name, inner] = value.entries().front();
  const auto point = [&, &inside = inner](const char* key) { return convert_point(inside.at(key), dimension, key); };
  if (name == "box") {
    const Box box{point("min"), point("max")};
    refuse_empty_box(box.min, box.max, dimension, inner.at("max").location(), name);
    shape.form = box;
  } else if (name == "cylinder") {
    const Cylinder cylinder{point("start"), point("end"), inner.at("radius").number()};
    refuse_same_ends(cylinder.start, cylinder.end, inner.at("end"), name);
    shape.form = cylinder;
  } else if (name == "sphere") {
    shape.form = Sphere{point("center"), inner.at("radius").number()};
  } else if (name == "plate_with_hole") {
    const PlateWithHole plate{point("min"), point("max"), point("center"), inner.at("radius").number()};
    refuse_empty_box(plate.min, plate.max, dimension, inner.at("max").location(), name);
    shape.form = plate;
  } else if (name == "union") {
    shape.form = Union{convert_parts(inner, dimension, name)};
  } else if (name == "difference") {
    shape.form = Difference{convert_parts(inner, dimension, name)};
  } else {
    shape.form = CloudFile{inner.text()};
  }
  return shape;
}

Crack convert_crack(const Value& value, Dimension dimension) {
  Crack crack;
  crack.location = value.location();
  const auto& [name, inner] = value.entries().front();
  const bool flat = dimension != Dimension::three;
  const bool rectangular = name == "rectangle";  // in 2-D it stands across the plane, so z is allowed
  const auto point = [&, &inside = inner](const char* key) {
    return convert_point(inside.at(key), dimension, key, rectangular);
  };
  if (rectangular) {
    const CrackRectangle rectangle{point("corner"), point("edge1"), point("edge2")};
    const double scale = length(rectangle.edge1) * length(rectangle.edge2);
    if (!(length(cross(rectangle.edge1, rectangle.edge2)) > 1e-12 * scale)) {
      refuse(inner.at("edge2").location(),
             "edge1 and edge2 of the rectangle must be two different directions, neither zero");
    }
    if (flat && rectangle.edge1[2] == 0 && rectangle.edge2[2] == 0) {
      refuse(inner.location(), "this rectangle lies in the plane of the 2-D bodies and cuts no bond; write a segment");
    }
    crack.form = rectangle;
  } else if (name == "disc") {
    const CrackDisc disc{point("center"), point("normal"), inner.at("radius").number()};
    if (length(disc.normal) == 0)
      refuse(inner.at("normal").location(), "normal of the disc is zero; give it a direction");
    crack.form = disc;
  } else {
    if (!flat) refuse(inner.location(), "a segment cuts only in 2-D; in 3-D write a rectangle or a disc");
    const CrackSegment segment{point("start"), point("end")};
    refuse_same_ends(segment.start, segment.end, inner.at("end"), name);
    crack.form = segment;
  }
  return crack;
}

}  // namespace perinox::deck
