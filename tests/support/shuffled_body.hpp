#pragma once
/// A body made by hand for tests of files: particles dealt out of order, every value a formula of the particle's id.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/core/record.hpp"

namespace perinox::test {

/// The value of component c of field `salt` at particle `id`. No two are equal.
inline double value_of(GlobalId id, int salt, int c = 0) {
  return 0.1 * static_cast<double>(id) + 100.0 * salt + 1000.0 * c + 1.0 / 3.0;
}

inline int block_of(GlobalId id) { return static_cast<int>(id % 2); }

/// A body of `total` particles dealt to the ranks in a shuffled order. With more than one rank, the last rank owns
/// none.
inline body::Body shuffled_body(const Communicator& communicator, GlobalId total, int dimension) {
  body::Body body;
  body.communicator = communicator;
  body.dimension = dimension;
  body.total = total;
  const int dealt_to = communicator.size() > 1 ? communicator.size() - 1 : 1;
  for (GlobalId k = 0; k < total; ++k) {
    const GlobalId id = (k * 7 + 3) % total;  // a permutation where 7 does not divide total
    if (k % dealt_to != communicator.rank()) continue;
    body.id.push_back(id);
    for (int c = 0; c < dimension; ++c) body.reference.push_back(value_of(id, 1, c));
    body.volume.push_back(value_of(id, 2));
    body.part.push_back(block_of(id));
    body.material.push_back(0);
    ++body.owned;
  }
  return body;
}

/// The [owned * components] values of field `salt`.
inline std::vector<double> field_values(const body::Body& body, int salt, int components) {
  std::vector<double> values;
  for (int i = 0; i < body.owned; ++i)
    for (int c = 0; c < components; ++c) values.push_back(value_of(body.id[static_cast<std::size_t>(i)], salt, c));
  return values;
}

inline StepRecord step_record(int step, double t) {
  StepRecord record;
  record.step = step;
  record.t = t;
  record.newton_iterations = 3;
  record.linear_iterations = 40 + step;
  record.end = 1;
  return record;
}

/// A new, empty directory whose name is the same on every rank of the program. Rank 0 removes it at the end.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    long long number = rank == 0 ? static_cast<long long>(::getpid()) : 0;
    MPI_Bcast(&number, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
    static int count = 0;
    path_ = (std::filesystem::temp_directory_path() /
             ("perinox_test_" + std::to_string(number) + "_" + std::to_string(++count)))
                .string();
    owner_ = rank == 0;
    if (owner_) std::filesystem::create_directory(path_);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  ~TemporaryDirectory() {
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code ignored;
    if (owner_) std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
  bool owner_ = false;
};

inline std::string file_text(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::vector<std::string> file_lines(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace perinox::test
