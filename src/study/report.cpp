#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace perinox::study {

namespace {
std::string notes_on(const std::vector<Row>& rows, const char* bullet) {
  std::string text;
  for (const Row& row : rows)
    if (!row.reason.empty()) text += fmt::format("{}{}: {}\n", bullet, row.run.name, row.reason);
  return text;
}

std::string in_cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}
}  // namespace

std::string terminal_report(const Study& study, const std::vector<Row>& rows, const std::vector<Plot>& plots) {
  const auto table = short_table(study, rows);
  std::vector<std::size_t> width(table[0].size());
  for (const auto& line : table)
    for (std::size_t c = 0; c < line.size(); ++c) width[c] = std::max(width[c], line[c].size());
  std::string text = "\n" + study.title + "\n";
  for (const auto& line : table) {
    for (std::size_t c = 0; c < line.size(); ++c) text += fmt::format("  {:>{}}", line[c], width[c]);
    text += '\n';
  }
  text += notes_on(rows, "  ");
  for (const Plot& plot : plots) {
    text += fmt::format("\n{} against {}\n", plot.chart.y.title, plot.chart.x.title);
    for (const std::string& finding : plot.findings) text += "  " + finding + "\n";
  }
  return text;
}

std::string page(const Study& study, const std::vector<Row>& rows, const std::vector<Plot>& plots) {
  std::string text = fmt::format(
      "# {}\n\nMade by `perinox study {}` from the deck {}. All numbers, with 17 digits: [study.csv](study.csv).\n\n",
      study.title, study.file, study.deck);
  const auto table = short_table(study, rows);
  for (std::size_t k = 0; k < table.size(); ++k) {
    for (const std::string& cell : table[k]) text += "| " + in_cell(cell) + " ";
    text += "|\n";
    if (k > 0) continue;
    for (std::size_t c = 0; c < table[0].size(); ++c) text += "|---";
    text += "|\n";
  }
  text +=
      "\nStatus 0: the run reached its end; 1: it stopped short; 128 and more: it was ended by a signal. Errors are "
      "relative; those of fields are root mean squares weighted by volume. CPU seconds are user and system time of all "
      "ranks; peak_megabytes is the memory of the largest process.\n";
  if (const std::string notes = notes_on(rows, "- "); !notes.empty()) text += "\n" + notes;
  for (const Plot& plot : plots) {
    text += fmt::format("\n## {} against {}\n\n![{}]({}.svg)\n\n{}\n", plot.chart.y.title, plot.chart.x.title,
                        plot.chart.title, plot.file, plot.meaning);
    if (!plot.findings.empty()) text += "\n";
    for (const std::string& finding : plot.findings)
      text += finding.back() == ':' ? finding + "\n\n" : "- " + finding + "\n";
    text += fmt::format("\nThe same as [{0}.png]({0}.png).\n", plot.file);
  }
  return text + "\n## Runs\n\nEach run's results, its output (run.log) and its errors (run.err) are in `runs/`.\n";
}

}  // namespace perinox::study
