#include "perinox/body/field_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "perinox/body/csv.hpp"
#include "perinox/body/neighbor_search.hpp"
#include "perinox/body/spacing.hpp"
#include "perinox/body/together.hpp"

namespace perinox::body {

namespace {

constexpr double kSamePlace = 1e-6;  ///< of the spacing: a row this near to a particle is its row
constexpr double kSameTime = 1e-9;   ///< of the largest time: such rows belong to one time

/// The distinct times of the table in ascending order, and the time of every row. Without the column t there is one
/// time.
struct Times {
  std::vector<double> distinct;
  std::vector<std::size_t> of_row;  ///< [rows]

  explicit Times(const CsvTable& table) : of_row(table.rows()) {
    if (!table.has("t")) {
      distinct.push_back(0);
      return;
    }
    const std::size_t column = table.column("t");
    std::vector<double> all;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      all.push_back(table.value(row, column));
      if (all.back() < 0)
        deck::refuse(table.where(row, column), fmt::format("t must not be negative, but is {:g}; the "
                                                           "load parameter starts at 0",
                                                           all.back()));
    }
    std::vector<double> sorted = all;
    std::sort(sorted.begin(), sorted.end());
    const double slack = kSameTime * sorted.back();
    for (const double t : sorted) {
      if (distinct.empty() || t > distinct.back() + slack) distinct.push_back(t);
    }
    for (std::size_t row = 0; row < all.size(); ++row) {
      const auto after = std::upper_bound(distinct.begin(), distinct.end(), all[row]);
      of_row[row] = static_cast<std::size_t>(after - distinct.begin()) - 1;
    }
  }
};

void refuse_third_component(const CsvTable& table) {
  for (const char* name : {"z", "uz"}) {
    const std::size_t column = table.column(name);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.value(row, column) == 0) continue;
      deck::refuse(table.where(row, column),
                   fmt::format("{} must be 0 in 2-D, but is {:g}", name, table.value(row, column)));
    }
  }
}

/// The owned particle of every row, -1 if it is another rank's. Refuses a row that belongs to no particle on any rank.
std::vector<LocalIndex> particles_of_rows(const CsvTable& table, const Body& body) {
  const std::vector<double> owned(body.reference.begin(), body.reference.begin() + body.owned * body.dimension);
  const NeighborSearch search(owned, body.dimension);
  const std::array<std::size_t, 3> columns{table.column("x"), table.column("y"), table.column("z")};
  std::vector<LocalIndex> particle(table.rows());
  std::vector<char> matched(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::array<double, 3> place{table.value(row, columns[0]), table.value(row, columns[1]),
                                      table.value(row, columns[2])};
    double distance = 0;
    const LocalIndex i = search.nearest(place.data(), distance);
    matched[row] = i >= 0 && distance <= kSamePlace * edge_of(body.volume[i], body.dimension);
    particle[row] = matched[row] ? i : -1;
  }
  // The sum is taken in pieces, because MPI counts in int.
  constexpr std::size_t kPiece = 1 << 26;
  for (std::size_t start = 0; start < matched.size(); start += kPiece) {
    MPI_Allreduce(MPI_IN_PLACE, matched.data() + start, static_cast<int>(std::min(kPiece, matched.size() - start)),
                  MPI_CHAR, MPI_MAX, body.communicator.mpi());
  }
  const auto stray = static_cast<std::size_t>(std::find(matched.begin(), matched.end(), 0) - matched.begin());
  if (stray < matched.size()) {
    deck::refuse(table.where(stray, columns[0]),
                 fmt::format("no particle is at ({:g}, {:g}, {:g}); a row is matched to a particle by its reference "
                             "position, to {:g} of the spacing",
                             table.value(stray, columns[0]), table.value(stray, columns[1]),
                             table.value(stray, columns[2]), kSamePlace));
  }
  return particle;
}

/// [times * owned] row + 1 of each owned particle at each time; 0: none. Refuses a second row for the same particle and
/// time.
std::vector<std::size_t> rows_of_particles(const CsvTable& table, const Times& times,
                                           const std::vector<LocalIndex>& particle, const Body& body) {
  const auto owned = static_cast<std::size_t>(body.owned);
  std::vector<std::size_t> rows(times.distinct.size() * owned);
  std::string sentence;
  long long line = 0;
  for (std::size_t row = 0; row < table.rows() && sentence.empty(); ++row) {
    if (particle[row] < 0) continue;
    std::size_t& first = rows[times.of_row[row] * owned + static_cast<std::size_t>(particle[row])];
    if (first == 0) {
      first = row + 1;
      continue;
    }
    line = table.line(row);
    const std::string when = table.has("t") ? fmt::format(" at t = {:g}", times.distinct[times.of_row[row]]) : "";
    sentence = fmt::format("{}: particle {} has its displacement{} on line {} already; take one of the two rows out",
                           table.where(row, 0).text(), body.id[particle[row]], when, table.line(first - 1));
  }
  refuse_first(body.communicator, line, sentence);
  return rows;
}

}  // namespace

FieldTable::FieldTable(const std::string& path, const deck::Location& asked_at, const Body& body,
                       const std::vector<LocalIndex>& set)
    : dimension_(body.dimension), count_(set.size()) {
  std::unique_ptr<CsvTable> table;
  std::unique_ptr<Times> times;
  together(body.communicator, [&] {
    table = std::make_unique<CsvTable>(path, asked_at,
                                       CsvColumns{"a displacement table", {"x", "y", "z", "ux", "uy", "uz"}, {"t"}});
    times = std::make_unique<Times>(*table);
    if (body.dimension == 2) refuse_third_component(*table);
  });
  has_time_ = table->has("t");
  times_ = times->distinct;
  const std::vector<std::size_t> rows = rows_of_particles(*table, *times, particles_of_rows(*table, body), body);

  const std::array<std::size_t, 3> columns{table->column("ux"), table->column("uy"), table->column("uz")};
  values_.reserve(times_.size() * set.size() * static_cast<std::size_t>(dimension_));
  std::string sentence;
  GlobalId missing = 0;
  for (std::size_t time = 0; time < times_.size(); ++time) {
    for (const LocalIndex i : set) {
      const std::size_t row = rows[time * static_cast<std::size_t>(body.owned) + static_cast<std::size_t>(i)];
      if (row > 0) {
        for (int c = 0; c < dimension_; ++c) values_.push_back(table->value(row - 1, columns[c]));
      } else if (sentence.empty() || body.id[i] < missing) {
        missing = body.id[i];
        const deck::Point x = body.position3(i);
        sentence = fmt::format(
            "{}: {} has no row for particle {} at ({:g}, {:g}, {:g}){}; add one, or impose the table "
            "on a smaller set",
            asked_at.text(), path, missing, x[0], x[1], x[2],
            has_time_ ? fmt::format(" at t = {:g}", times_[time]) : "");
      }
    }
  }
  refuse_first(body.communicator, missing, sentence);
}

void FieldTable::evaluate(std::size_t k, double t, double* out) const {
  const auto dimension = static_cast<std::size_t>(dimension_);
  const auto at = [&](std::size_t time) { return &values_[(time * count_ + k) * dimension]; };
  const auto copy = [&](std::size_t time, double factor) {
    for (std::size_t c = 0; c < dimension; ++c) out[c] = factor * at(time)[c];
  };
  if (!has_time_) return copy(0, t > 0 ? 1 : 0);
  const auto after = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
  if (after == times_.size()) return copy(after - 1, 1);
  if (after == 0) return copy(0, t > 0 ? t / times_[0] : 0);  // from rest at t = 0 to the first given time
  const double share = (t - times_[after - 1]) / (times_[after] - times_[after - 1]);
  for (std::size_t c = 0; c < dimension; ++c) out[c] = (1 - share) * at(after - 1)[c] + share * at(after)[c];
}

}  // namespace perinox::body
