#pragma once
/// What a study file says: a deck, the parameters to sweep, and what to measure in every run.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "perinox/deck/location.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::study {

/// One value of the deck replaced, as `--set key=value` does it; the key `ranks` is the number of MPI ranks instead.
struct Setting {
  deck::Location location;
  std::string key;
  std::string value;  ///< YAML; {name} stands for the value of the sweep of that name
};

struct SweepPoint {
  std::string label;
  std::optional<double> number;  ///< of a label that is one
  std::vector<Setting> set;
};

struct Sweep {
  deck::Location location;
  std::string name;
  std::vector<SweepPoint> points;

  /// True if every label is a number.
  bool numeric() const;
};

/// Which row of history.csv a measure is of: the last one of a run that has come to its end, the first or last one
/// there is, or that of the largest or smallest value, of which max and min take the value and argmax and argmin the
/// argument.
enum class Take { end, first, last, max, argmax, min, argmin };

/// Either a formula of the columns of history.csv, with or without an exact value, or a field against a solution or
/// another run.
struct Measure {
  deck::Location location;
  std::string name;
  std::string history;       ///< formula of the columns of history.csv; empty for a field
  std::optional<double> at;  ///< load parameter; nothing: the end of the run
  Take take = Take::end;     ///< of a history measure
  std::string argument;      ///< formula that argmax and argmin take
  std::string exact;         ///< formula; empty where there is none
  std::string field;
  std::map<std::string, std::string> solution;  ///< formulas of some of components_of(field)
  std::string reference;                        ///< "finest", or a results.h5
  std::string where;  ///< condition on the particles, or on the rows of history.csv; empty: all

  /// False for what a run that stopped short has too.
  bool needs_the_end() const { return !at && take == Take::end; }
  bool compares() const { return !field.empty() || !exact.empty(); }
  /// Column of the relative error.
  std::string error_column() const { return name + "_error"; }
  /// Every column of this measure, the error first.
  std::vector<std::string> columns() const;
};

/// A plot asked for: columns of study.csv or names of sweeps.
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
  int newton_step = 0;  ///< of kind newton; 0: the last one committed
  int repeat = 1;       ///< times that each run is made, for its cost
  std::vector<Setting> set;
  std::vector<Sweep> sweep;
  std::vector<Measure> measures;
  std::vector<PlotRequest> plots;
};

/// The keys of a study file.
deck::Key declare_study();

/// Throws InputError with `file:line:column: sentence`.
Study read(const std::string& file);
/// The same from text; `file` names the folder that paths start from.
Study read_text(const std::string& yaml, const std::string& file);

/// Names of the components of a field with this many columns in results.h5: value; x y z; xx xy xz yy yz zz.
const std::vector<std::string>& components_of(int columns);
/// Their columns: of the nine of a symmetric tensor those of xx xy xz yy yz zz.
const std::vector<std::size_t>& places_of(int columns);

/// The words of `take`, in the order of the enumeration.
const std::vector<std::string>& take_words();

/// Columns of study.csv that every study has, after those of its sweeps and measures.
const std::vector<std::string>& cost_columns();

}  // namespace perinox::study
