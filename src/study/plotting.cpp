#include "plotting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace perinox::study {

namespace {
bool is_error(const Study& study, const std::string& column) {
  return std::any_of(study.measures.begin(), study.measures.end(), [&](const Measure& measure) {
    return measure.compares() && (column == measure.error_column() || column == measure.name + "_largest");
  });
}

bool is_cost(const std::string& column) {
  return std::find(cost_columns().begin(), cost_columns().end(), column) != cost_columns().end();
}

/// The value that is drawn. Errors are drawn by their size.
double shown(const Study& study, const Row& row, const std::string& column) {
  const double value = row.value(column);
  return is_error(study, column) ? std::abs(value) : value;
}

std::string axis_title(const Study& study, const std::string& column) {
  if (column == "cpu_seconds") return "CPU seconds, all ranks";
  if (column == "wall_seconds") return "wall seconds";
  if (column == "solve_seconds") return "wall seconds of the load steps";
  if (column == "peak_megabytes") return "memory of the largest process, MB";
  if (is_error(study, column)) {
    const bool largest = column.size() > 8 && column.compare(column.size() - 8, 8, "_largest") == 0;
    return fmt::format("{} error of {}", largest ? "largest relative" : "relative",
                       column.substr(0, column.size() - (largest ? 8 : 6)));
  }
  std::string title = column;
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

/// The rows that differ in sweep `along` only, in the rows' order, with what they have in common.
struct Series {
  std::string name;
  std::vector<const Row*> rows;
};

std::vector<Series> series_of(const Study& study, const std::vector<Row>& rows, std::size_t along) {
  std::vector<Series> all;
  for (const Row& row : rows) {
    std::string name;
    for (std::size_t s = 0; s < study.sweep.size(); ++s) {
      if (s == along || study.sweep[s].points.size() < 2) continue;
      const bool number = study.sweep[s].points[row.run.point[s]].number.has_value();
      name += (name.empty() ? "" : ", ") + (number ? study.sweep[s].name + " " : "") + row.run.label[s];
    }
    auto found = std::find_if(all.begin(), all.end(), [&](const Series& one) { return one.name == name; });
    if (found == all.end()) found = all.insert(all.end(), {name, {}});
    found->rows.push_back(&row);
  }
  return all;
}

bool all_positive(const Study& study, const std::vector<Row>& rows, const std::string& column) {
  bool any = false;
  for (const Row& row : rows) {
    const double value = shown(study, row, column);
    if (std::isnan(value)) continue;
    if (!(value > 0)) return false;
    any = true;
  }
  return any;
}

/// The values of a sweep of few, in rising order. They are the labels of its axis.
std::vector<double> marks_of(const Study& study, const std::string& column) {
  constexpr std::size_t most = 8;
  std::vector<double> marks;
  for (const Sweep& sweep : study.sweep)
    if (sweep.name == column && sweep.numeric() && sweep.points.size() <= most)
      for (const SweepPoint& point : sweep.points) marks.push_back(*point.number);
  std::sort(marks.begin(), marks.end());
  return marks;
}

bool changes_sign(const std::vector<const Row*>& rows, const std::string& column) {
  const auto any = [&](int sign) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row* row) { return sign * row->value(column) > 0; });
  };
  return any(1) && any(-1);
}

void mark_front(Plot& plot, const Study& study, const std::vector<Row>& rows, const PlotRequest& request) {
  std::vector<Pair> points;
  std::vector<const Row*> owners;
  for (const Row& row : rows) {
    const Pair p{shown(study, row, request.x), shown(study, row, request.y)};
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    points.push_back(p);
    owners.push_back(&row);
  }
  Curve front;
  front.name = "Pareto front";
  front.style = Curve::Style::rings;
  plot.findings.emplace_back("On the Pareto front, cheapest first:");
  for (const std::size_t k : pareto_front(points)) {
    front.points.push_back(points[k]);
    plot.findings.push_back(fmt::format("{}: {} at {} {}", fmt::join(owners[k]->run.label, ", "),
                                        short_number(points[k].y), short_number(points[k].x), request.x));
  }
  plot.chart.curves.push_back(std::move(front));
}

Plot plot_of(const Study& study, const std::vector<Row>& rows, const PlotRequest& request) {
  Plot plot;
  plot.file = request.y + "_against_" + request.x;
  const bool work = is_cost(request.x) && is_error(study, request.y) && request.x != "ranks" &&
                    request.x != "particles" && request.x != "unknowns" && request.x != "bonds";
  Chart& chart = plot.chart;
  chart.title = study.title;
  chart.x = {axis_title(study, request.x), all_positive(study, rows, request.x), marks_of(study, request.x)};
  // An error of exactly zero is left out of the picture, because it would make the axis linear.
  chart.y = {axis_title(study, request.y), is_error(study, request.y) || all_positive(study, rows, request.y), {}};
  std::size_t along = first_numeric(study);
  for (std::size_t s = 0; s < study.sweep.size(); ++s)
    if (study.sweep[s].name == request.x) along = s;
  for (const Series& series : series_of(study, rows, along)) {
    Curve curve;
    curve.name = series.name;
    for (const Row* row : series.rows)
      curve.points.push_back({shown(study, *row, request.x), shown(study, *row, request.y)});
    const auto slope = chart.x.logarithmic && chart.y.logarithmic ? log_slope(curve.points) : std::nullopt;
    if (slope && !work && changes_sign(series.rows, request.y)) {
      plot.findings.push_back(fmt::format("{}the error changes sign, so that no slope is fitted",
                                          series.name.empty() ? "" : series.name + ": "));
      curve.name += (series.name.empty() ? "" : ", ") + std::string("changes sign");
    } else if (slope && !work) {
      const auto count =
          std::count_if(curve.points.begin(), curve.points.end(), [](const Pair& p) { return p.x > 0 && p.y > 0; });
      plot.findings.push_back(
          fmt::format("{}slope {:.2f} over {} points", series.name.empty() ? "" : series.name + ": ", *slope, count));
      curve.name += fmt::format("{}slope {:.2f}", series.name.empty() ? "" : ", ", *slope);
    }
    chart.curves.push_back(std::move(curve));
  }
  if (work) {
    plot.meaning =
        "Down is more accurate and left is cheaper. Circled runs are the Pareto front: no other run is both cheaper "
        "and "
        "more accurate.";
    mark_front(plot, study, rows, request);
  } else if (chart.x.logarithmic && chart.y.logarithmic) {
    plot.meaning = fmt::format(
        "The slope of a curve is the power of {} with which {} changes, fitted to the logarithms of all its points.",
        chart.x.title, chart.y.title);
  } else {
    plot.meaning = fmt::format("{} against {}.", chart.y.title, chart.x.title);
  }
  return plot;
}

Plot newton_plot(const Study& study, const std::vector<Row>& rows) {
  Plot plot;
  plot.file = "newton";
  plot.chart.title = study.title;
  plot.chart.x = {"Newton iteration", false, {}};
  plot.chart.y = {"relative residual", true, {}};
  plot.meaning =
      "Residual of each Newton iteration over the reactions. A straight line is linear convergence; a curve that bends "
      "down, its digits doubling each time, is quadratic. The order is log(r2/r1)/log(r1/r0) of the last three "
      "residuals.";
  for (const Series& series : series_of(study, rows, study.sweep.size())) {
    for (const Row* row : series.rows) {
      Curve curve;
      curve.name = series.name;
      for (std::size_t k = 0; k < row->residuals.size(); ++k)
        curve.points.push_back({static_cast<double>(k), row->residuals[k]});
      const auto order = newton_order(row->residuals);
      const std::string said = order ? fmt::format("order {:.2f}", *order) : "no order seen";
      plot.findings.push_back(fmt::format("{}: {} over {} iterations", series.name, said,
                                          row->residuals.empty() ? 0 : row->residuals.size() - 1));
      curve.name += ", " + said;
      plot.chart.curves.push_back(std::move(curve));
    }
  }
  return plot;
}
}  // namespace

std::vector<Plot> plots_of(const Study& study, const std::vector<Row>& rows) {
  std::vector<Plot> plots;
  if (study.kind == Kind::newton) plots.push_back(newton_plot(study, rows));
  std::vector<PlotRequest> requests = study.plots;
  if (requests.empty()) {
    const std::size_t along = first_numeric(study);
    for (const Measure& measure : study.measures) {
      const std::string y = measure.compares() ? measure.error_column() : measure.name;
      if (along < study.sweep.size()) requests.push_back({measure.location, study.sweep[along].name, y});
      if (measure.compares()) requests.push_back({measure.location, "cpu_seconds", y});
    }
  }
  for (const PlotRequest& request : requests) plots.push_back(plot_of(study, rows, request));
  plots.erase(std::remove_if(plots.begin(), plots.end(), [](const Plot& plot) { return !plot.chart.has_points(); }),
              plots.end());
  return plots;
}

}  // namespace perinox::study
