#include "chart.hpp"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "perinox/core/error.hpp"
#include "scale.hpp"

namespace perinox::study {

namespace {
constexpr double width = 900, height = 540;
constexpr double left = 90, top = 50, bottom = 70, right = 20;
constexpr double enlarged = 2;  ///< pixels of the PNG a unit

struct Colour {
  double red, green, blue;
};
constexpr std::array<Colour, 7> colours{{{0, 0.447, 0.698},
                                         {0.835, 0.369, 0},
                                         {0, 0.62, 0.451},
                                         {0.8, 0.475, 0.655},
                                         {0.902, 0.624, 0},
                                         {0.337, 0.706, 0.914},
                                         {0.2, 0.2, 0.2}}};

bool drawable(const Chart& chart, const Pair& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && (!chart.x.logarithmic || p.x > 0) &&
         (!chart.y.logarithmic || p.y > 0);
}

/// The scale's ticks. They have no labels where the axis says where its labels stand.
std::vector<Tick> ticks_of(const Axis& axis, const Scale& scale) {
  std::vector<Tick> ticks = scale.ticks();
  if (axis.marked.empty()) return ticks;
  for (Tick& tick : ticks) tick.label.clear();
  if (!axis.logarithmic) ticks.clear();
  for (const double value : axis.marked) ticks.push_back({value, tick_label(value)});
  return ticks;
}

class Pen {
 public:
  explicit Pen(cairo_t* context) : c_(context) {
    cairo_select_font_face(c_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }

  void draw(const Chart& chart) {
    cairo_set_source_rgb(c_, 1, 1, 1);
    cairo_paint(c_);
    find_ranges(chart);
    place_legend(chart);
    axes(chart);
    cairo_save(c_);
    cairo_rectangle(c_, left - 8, top - 8, plot_width_ + 16, plot_height_ + 16);
    cairo_clip(c_);
    for (std::size_t k = 0; k < chart.curves.size(); ++k) curve(chart, k);
    cairo_restore(c_);
    legend(chart);
  }

 private:
  void find_ranges(const Chart& chart) {
    const double most = std::numeric_limits<double>::infinity();
    double low[2] = {most, most}, high[2] = {-most, -most};
    for (const Curve& one : chart.curves)
      for (const Pair& p : one.points) {
        if (!drawable(chart, p)) continue;
        const double v[2] = {p.x, p.y};
        for (int a = 0; a < 2; ++a) low[a] = std::min(low[a], v[a]), high[a] = std::max(high[a], v[a]);
      }
    x_ = std::make_unique<Scale>(low[0], high[0], chart.x.logarithmic);
    y_ = std::make_unique<Scale>(low[1], high[1], chart.y.logarithmic);
  }

  double text_width(const std::string& text, double size) {
    cairo_set_font_size(c_, size);
    cairo_text_extents_t extent;
    cairo_text_extents(c_, text.c_str(), &extent);
    return extent.x_advance;
  }

  /// Writes a text. align: 0 the text starts at x, 0.5 it is centred there, 1 it ends there.
  void text(const std::string& words, double x, double y, double size, double align) {
    const double shift = align * text_width(words, size);
    cairo_set_source_rgb(c_, 0.1, 0.1, 0.1);
    cairo_move_to(c_, x - shift, y);
    cairo_show_text(c_, words.c_str());
  }

  void line(double x1, double y1, double x2, double y2) {
    cairo_move_to(c_, x1, y1);
    cairo_line_to(c_, x2, y2);
    cairo_stroke(c_);
  }

  void place_legend(const Chart& chart) {
    legend_width_ = 0;
    for (const Curve& one : chart.curves)
      if (!one.name.empty()) legend_width_ = std::max(legend_width_, text_width(one.name, 13) + 50);
    legend_width_ = std::min(legend_width_, 0.5 * width);
    plot_width_ = width - left - right - legend_width_;
    plot_height_ = height - top - bottom;
  }

  double place_x(double value) const { return left + plot_width_ * x_->position(value); }
  double place_y(double value) const { return top + plot_height_ * (1 - y_->position(value)); }

  void axes(const Chart& chart) {
    const double right_end = left + plot_width_, foot = top + plot_height_;
    cairo_set_line_width(c_, 1);
    double last_end = -1;
    for (const Tick& tick : ticks_of(chart.x, *x_)) {
      const double x = place_x(tick.value);
      const bool labelled = !tick.label.empty();
      grid(x, top, x, foot, labelled);
      line(x, foot, x, foot + (labelled ? 7 : 4));
      const double half = text_width(tick.label, 13) / 2;
      if (!labelled || x - half < last_end + 6) continue;
      text(tick.label, x, foot + 22, 13, 0.5);
      last_end = x + half;
    }
    double last_y = height;
    for (const Tick& tick : ticks_of(chart.y, *y_)) {
      const double y = place_y(tick.value);
      const bool labelled = !tick.label.empty();
      grid(left, y, right_end, y, labelled);
      line(left - (labelled ? 7 : 4), y, left, y);
      if (!labelled || last_y - y < 14) continue;
      text(tick.label, left - 11, y + 4.5, 13, 1);
      last_y = y;
    }
    cairo_set_source_rgb(c_, 0.1, 0.1, 0.1);
    cairo_rectangle(c_, left, top, plot_width_, plot_height_);
    cairo_stroke(c_);
    text(chart.title, left, 30, 17, 0);
    text(chart.x.title, left + plot_width_ / 2, height - 20, 15, 0.5);
    cairo_save(c_);
    cairo_translate(c_, 24, top + plot_height_ / 2);
    cairo_rotate(c_, -std::acos(0.0));
    text(chart.y.title, 0, 0, 15, 0.5);
    cairo_restore(c_);
  }

  void grid(double x1, double y1, double x2, double y2, bool strong) {
    const double grey = strong ? 0.85 : 0.94;
    cairo_set_source_rgb(c_, grey, grey, grey);
    line(x1, y1, x2, y2);
    cairo_set_source_rgb(c_, 0.1, 0.1, 0.1);
  }

  void colour(std::size_t k) {
    const Colour& one = colours[k % colours.size()];
    cairo_set_source_rgb(c_, one.red, one.green, one.blue);
  }

  void marker(std::size_t kind, double x, double y) {
    constexpr double r = 5;
    cairo_new_path(c_);
    const auto polygon = [&](std::initializer_list<Pair> corners) {
      for (const Pair& p : corners) cairo_line_to(c_, x + r * p.x, y + r * p.y);
      cairo_close_path(c_);
    };
    switch (kind % 5) {
      case 0:
        cairo_arc(c_, x, y, r, 0, 4 * std::acos(0.0));
        break;
      case 1:
        polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
        break;
      case 2:
        polygon({{0, -1.2}, {1.1, 0.8}, {-1.1, 0.8}});
        break;
      case 3:
        polygon({{0, -1.3}, {1.1, 0}, {0, 1.3}, {-1.1, 0}});
        break;
      default:
        polygon({{0, 1.2}, {1.1, -0.8}, {-1.1, -0.8}});
    }
    cairo_fill(c_);
  }

  void ring(double x, double y) {
    cairo_new_path(c_);
    cairo_set_line_width(c_, 1.5);
    cairo_arc(c_, x, y, 9, 0, 4 * std::acos(0.0));
    cairo_stroke(c_);
  }

  void stroke_of(const Curve& one, std::size_t k) {
    static const double dashes[] = {6, 4};
    colour(k);
    cairo_set_line_width(c_, 2);
    cairo_set_dash(c_, dashes, one.style == Curve::Style::dashed ? 2 : 0, 0);
    if (one.style == Curve::Style::rings) cairo_set_source_rgb(c_, 0.1, 0.1, 0.1);
  }

  void curve(const Chart& chart, std::size_t k) {
    const Curve& one = chart.curves[k];
    stroke_of(one, k);
    cairo_new_path(c_);
    if (one.style == Curve::Style::rings) cairo_set_dash(c_, std::array<double, 2>{2, 4}.data(), 2, 0);
    for (const Pair& p : one.points)
      if (drawable(chart, p)) cairo_line_to(c_, place_x(p.x), place_y(p.y));
    cairo_stroke(c_);
    cairo_set_dash(c_, nullptr, 0, 0);
    for (const Pair& p : one.points) {
      if (!drawable(chart, p)) continue;
      if (one.style == Curve::Style::rings)
        ring(place_x(p.x), place_y(p.y));
      else if (one.style == Curve::Style::line)
        marker(k, place_x(p.x), place_y(p.y));
    }
  }

  void legend(const Chart& chart) {
    const double x = left + plot_width_ + 14;
    double y = top + 12;
    const double row = std::min(24.0, plot_height_ / static_cast<double>(chart.curves.size()));
    for (std::size_t k = 0; k < chart.curves.size(); ++k) {
      const Curve& one = chart.curves[k];
      if (one.name.empty()) continue;
      stroke_of(one, k);
      if (one.style == Curve::Style::rings) {
        ring(x + 12, y);
      } else {
        line(x, y, x + 24, y);
        cairo_set_dash(c_, nullptr, 0, 0);
        if (one.style == Curve::Style::line) marker(k, x + 12, y);
      }
      text(one.name, x + 32, y + 4.5, 13, 0);
      y += row;
    }
  }

  cairo_t* c_;
  std::unique_ptr<Scale> x_, y_;
  double legend_width_ = 0, plot_width_ = 0, plot_height_ = 0;
};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void draw_on(cairo_surface_t* surface, const Chart& chart, double scale) {
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface), cairo_destroy);
  cairo_scale(context.get(), scale, scale);
  Pen(context.get()).draw(chart);
}

void check(cairo_status_t status, const std::string& path) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw RunError(fmt::format("{} cannot be written: {}", path, cairo_status_to_string(status)));
}
}  // namespace

bool Chart::has_points() const {
  for (const Curve& one : curves)
    for (const Pair& p : one.points)
      if (drawable(*this, p)) return true;
  return false;
}

void draw(const Chart& chart, const std::string& path) {
  if (!chart.has_points()) throw RunError(path + ": there is no point to draw");
  const Surface vector(cairo_svg_surface_create((path + ".svg").c_str(), width, height), cairo_surface_destroy);
  draw_on(vector.get(), chart, 1);
  cairo_surface_finish(vector.get());
  check(cairo_surface_status(vector.get()), path + ".svg");
  const Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(enlarged * width),
                                                 static_cast<int>(enlarged * height)),
                      cairo_surface_destroy);
  draw_on(image.get(), chart, enlarged);
  check(cairo_surface_write_to_png(image.get(), (path + ".png").c_str()), path + ".png");
}

}  // namespace perinox::study
