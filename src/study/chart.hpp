#pragma once
/// Line charts, drawn with cairo. The drawing does not depend on the kind of file.
#include <string>
#include <vector>

#include "fit.hpp"

namespace perinox::study {

struct Curve {
  std::string name;          ///< name in the legend; empty: not there
  std::vector<Pair> points;  ///< in the order in which they are joined
  enum class Style { line, dashed, rings } style = Style::line;
};

struct Axis {
  std::string title;
  bool logarithmic = false;      ///< values that are not positive are not drawn
  std::vector<double> marked{};  ///< places of the labels; empty: at round numbers
};

struct Chart {
  std::string title;
  Axis x, y;
  std::vector<Curve> curves;

  /// True if at least one point can be drawn.
  bool has_points() const;
};

/// Writes `path`.svg and `path`.png. The colours are those of Okabe and Ito, which can be told apart with any kind of
/// colour vision; each curve has a marker of its own too. Throws RunError if a file cannot be written.
void draw(const Chart& chart, const std::string& path);

}  // namespace perinox::study
