#pragma once
/// What a run of a deck says about every particle and in its history, and how far two such answers are apart.
#include <mpi.h>

#include <map>
#include <string>
#include <vector>

#include "perinox/core/types.hpp"
#include "transformation.hpp"

namespace perinox::invariance {

struct FieldValues {
  int components = 1;
  std::vector<double> values;  ///< [particles * components]
};

/// The answer of one run. It is whole on rank 0 of the run's communicator; the others have only `refused` and
/// `stopped`.
struct Answer {
  std::string refused;  ///< sentence of an InputError; there is then nothing else
  std::string stopped;  ///< the reason, if the run stopped short; fields are those of the last step
  int dimension = 3;
  double spacing = 0;                         ///< cube or square root of the mean volume
  std::vector<double> place;                  ///< [particles * 3] reference position
  std::vector<double> volume;                 ///< [particles]
  std::vector<long long> family;              ///< [particles] number of bonds at the start
  std::map<std::string, FieldValues> fields;  ///< fields of the last step
  struct Row {
    double t = 0;
    std::array<double, 3> energies{};  ///< stored, dissipated, external work
    std::vector<double> reactions;     ///< history entries of forces, in the deck's order
    std::vector<double> movements;     ///< of displacements
    std::vector<double> shares;        ///< shares of the body that have yielded
    long long broken_bonds = 0;
  };
  std::vector<Row> rows;
};

/// Runs a deck given as text. folder: the place from which its file names count. A RunError is part of the answer, like
/// a refusal: both must occur or be absent alike.
Answer answer_of(const std::string& yaml, const std::string& folder, MPI_Comm comm);

/// The rows that are compared.
enum class Rows {
  all,   ///< every step
  last,  ///< only the last one: the way there differs
  none,
};

/// The largest deviation of what is compared, each relative to the largest size of its kind: fields of length, of
/// force, of stress; reactions; movements; energies. Particles of `base` without a partner in `changed` are a deviation
/// of 1, and so is a different number of particles, unless `changed` may have more. `what`, if given, gets the name of
/// the quantity.
double deviation(const Answer& base, const Answer& changed, const Transformation& change, Rows rows, bool more,
                 std::string* what = nullptr);

}  // namespace perinox::invariance
