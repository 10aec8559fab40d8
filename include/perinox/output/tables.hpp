#pragma once
#include <cstdio>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"

namespace perinox::output {

/// A text file that grows a line at a time. Each line is on its way to the disk when append() returns. One rank owns
/// the file. Failures are kept and not thrown until the ranks can speak about them together: see failure().
class GrowingFile {
 public:
  /// kept 0: makes a new file that begins with the header, if there is one. Otherwise the file goes on behind its first
  /// `kept` bytes, and what follows them is dropped: see continuable().
  explicit GrowingFile(std::string path, const std::string& header = "", long long kept = 0);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void append(const std::string& line);
  /// Brings the file to the disk and returns its length in bytes.
  long long sync();
  /// True if a file begins with this header, has `kept` bytes and a line ends there.
  static bool continuable(const std::string& path, const std::string& header, long long kept);
  /// The first failure as a sentence with the path and the reason; "" if there was none.
  const std::string& failure() const { return failure_; }

 private:
  std::string path_;
  std::FILE* file_;
  std::string failure_;
};

/// Writes `history.csv`, which has one row for each committed step. Its columns are step, t, one for each name,
/// stored_energy, dissipated_energy, external_work, newton_iterations, linear_iterations, seconds, products, and
/// seconds_<section> of each section of the profile. For scenes that have them, those of FractureRow and MotionRow
/// follow, by their names, and overlap. Numbers are written as %.17g, so that they read back to the same double, the
/// sections' seconds with six digits.
class HistoryTable {
 public:
  struct Columns {
    bool fracture = false;
    bool motion = false;
    bool phases = false;  ///< with motion
    bool overlap = false;
    static Columns of(const deck::Deck& deck);
  };
  HistoryTable(const std::string& path, const std::vector<std::string>& names) : HistoryTable(path, names, {}) {}
  /// kept: bytes of an existing table that stay; 0: makes a new one.
  HistoryTable(const std::string& path, const std::vector<std::string>& names, Columns columns, long long kept = 0);
  void row(const StepRecord& record);
  static std::string header(const std::vector<std::string>& names, Columns columns);
  long long sync() { return file_.sync(); }
  const std::string& failure() const { return file_.failure(); }

 private:
  GrowingFile file_;
  Columns columns_;
};

/// Names of the history entries of a deck.
std::vector<std::string> history_names(const deck::Deck& deck);
/// Names of all columns that a run of the deck writes.
std::vector<std::string> history_columns(const deck::Deck& deck);

/// Writes `convergence.csv`, which has one row for each Newton iteration. Its columns are step, t, attempt, iteration,
/// residual, relative_residual, update, relative_update, linear_iterations, forcing, step_length. `attempt` counts from
/// 1 within a step. The rows of a rejected attempt stay; those of the shorter one follow with the next attempt number
/// (and their own t).
class ConvergenceTable {
 public:
  explicit ConvergenceTable(const std::string& path, long long kept = 0);
  void row(const NewtonIteration& row, int attempt);
  static std::string header();
  long long sync() { return file_.sync(); }
  const std::string& failure() const { return file_.failure(); }

 private:
  GrowingFile file_;
};

}  // namespace perinox::output
