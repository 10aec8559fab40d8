#pragma once
/// The contents of a study file: a deck, the parameters to sweep, and what to measure in every run.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "perinox/deck/location.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::study {

/// Replaces one value of the deck, as `--set key=value` does. The key `ranks` is the number of MPI ranks instead.
struct Setting {
  deck::Location location;
  std::string key;
  std::string value;  ///< YAML, in which {name} stands for the value of the sweep of that name
};

struct SweepPoint {
  std::string label;
  std::optional<double> number;  ///< value of a label that is a number
  std::vector<Setting> set;
};

struct Sweep {
  deck::Location location;
  std::string name;
  std::vector<SweepPoint> points;

  /// True if every label is a number.
  bool numeric() const;
};

/// The row of history.csv that a measure looks at: the last one of a run that has come to its end, the first or last
/// one there is, or that of the largest or smallest value. In that row max and min take the value, argmax and argmin
/// the argument.
enum class Take { end, first, last, max, argmax, min, argmin };

/// One measure: either a formula of the columns of history.csv, with or without an exact value, or a field that is
/// compared with a solution or with another run.
struct Measure {
  deck::Location location;
  std::string name;
  std::string history;       ///< formula of the columns of history.csv; empty for a field
  std::optional<double> at;  ///< load parameter; absent: the end of the run
  Take take = Take::end;     ///< for a history measure
  std::string argument;      ///< formula that argmax and argmin take
  std::string exact;         ///< formula; empty where there is none
  std::string field;
  std::map<std::string, std::string> solution;  ///< formulas for some of components_of(field)
  std::string reference;                        ///< "finest", or a results.h5
  std::string where;  ///< condition on the particles, or on the rows of history.csv; empty: all

  /// False for a measure that a run that stopped short has too.
  bool needs_the_end() const { return !at && take == Take::end; }
  bool compares() const { return !field.empty() || !exact.empty(); }
  /// Name of the column of the relative error.
  std::string error_column() const { return name + "_error"; }
  /// All columns of this measure, the error first.
  std::vector<std::string> columns() const;
};

/// A plot that the study asks for. x and y are columns of study.csv or names of sweeps.
struct PlotRequest {
  deck::Location location;
  std::string x, y;
};

enum class Kind { convergence, newton };

struct Study {
  std::string file;
  std::string title;
  std::string deck;  ///< path that can be opened from here
  Kind kind = Kind::convergence;
  int newton_step = 0;  ///< for kind newton; 0: the last step committed
  int repeat = 1;       ///< number of times that each run is made, to measure its cost
  std::vector<Setting> set;
  std::vector<Sweep> sweep;
  std::vector<Measure> measures;
  std::vector<PlotRequest> plots;
};

/// Declares the keys of a study file.
deck::Key declare_study();

/// Reads a study file. Throws InputError with `file:line:column: sentence`.
Study read(const std::string& file);
/// Reads a study from text. `file` names the folder from which paths count.
Study read_text(const std::string& yaml, const std::string& file);

/// Names of the components of a field with this many columns in results.h5: value; x y z; xx xy xz yy yz zz.
const std::vector<std::string>& components_of(int columns);
/// Columns of these components. For a symmetric tensor they are those of xx xy xz yy yz zz among its nine.
const std::vector<std::size_t>& places_of(int columns);

/// The words of `take`, in the order of the enumeration.
const std::vector<std::string>& take_words();

/// Columns that every study.csv has, after those of its sweeps and measures.
const std::vector<std::string>& cost_columns();

}  // namespace perinox::study
