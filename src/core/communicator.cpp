#include "perinox/core/communicator.hpp"

#include <algorithm>

#include "perinox/core/error.hpp"
#include "perinox/core/sentence.hpp"

namespace perinox {

namespace {
template <class T>
T reduce(T value, MPI_Datatype type, MPI_Op operation, MPI_Comm comm) {
  T result = value;
  MPI_Allreduce(&value, &result, 1, type, operation, comm);
  return result;
}
}  // namespace

Communicator::Communicator(MPI_Comm comm) : comm_(comm), profile_(std::make_shared<Profile>()) {
  MPI_Comm_rank(comm, &rank_);
  MPI_Comm_size(comm, &size_);
}

double Communicator::sum(double value) const { return reduce(value, MPI_DOUBLE, MPI_SUM, comm_); }
long long Communicator::sum(long long value) const { return reduce(value, MPI_LONG_LONG, MPI_SUM, comm_); }
double Communicator::max(double value) const { return reduce(value, MPI_DOUBLE, MPI_MAX, comm_); }
long long Communicator::max(long long value) const { return reduce(value, MPI_LONG_LONG, MPI_MAX, comm_); }
double Communicator::min(double value) const { return reduce(value, MPI_DOUBLE, MPI_MIN, comm_); }
bool Communicator::any(bool value) const { return reduce(value ? 1 : 0, MPI_INT, MPI_MAX, comm_) != 0; }

long long Communicator::exclusive_scan(long long value) const {
  long long before = 0;
  MPI_Exscan(&value, &before, 1, MPI_LONG_LONG, MPI_SUM, comm_);
  return rank_ == 0 ? 0 : before;
}

void Communicator::sum(std::vector<double>& values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, comm_);
}

void Communicator::max(std::vector<double>& values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, comm_);
}

ProfileReading Communicator::slowest(const ProfileReading& reading) const {
  std::vector<double> values(reading.seconds.begin(), reading.seconds.end());
  values.push_back(reading.wall);
  max(values);
  ProfileReading all = reading;
  all.wall = values.back();
  std::copy_n(values.begin(), section_count, all.seconds.begin());
  return all;
}

std::vector<double> Communicator::gather(double value) const {
  std::vector<double> all(static_cast<std::size_t>(size_));
  MPI_Allgather(&value, 1, MPI_DOUBLE, all.data(), 1, MPI_DOUBLE, comm_);
  return all;
}

std::vector<long long> Communicator::gather(long long value) const {
  std::vector<long long> all(static_cast<std::size_t>(size_));
  MPI_Allgather(&value, 1, MPI_LONG_LONG, all.data(), 1, MPI_LONG_LONG, comm_);
  return all;
}

namespace {

template <class Number>
std::vector<Number> gather_lists(const std::vector<Number>& values, MPI_Datatype type, const Communicator& ranks) {
  std::vector<int> counts, starts;
  int total = 0;
  for (const long long count : ranks.gather(static_cast<long long>(values.size()))) {
    starts.push_back(total);
    counts.push_back(static_cast<int>(count));
    total += counts.back();
  }
  std::vector<Number> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(values.data(), static_cast<int>(values.size()), type, all.data(), counts.data(), starts.data(), type,
                 ranks.mpi());
  return all;
}

}  // namespace

std::vector<double> Communicator::gather(const std::vector<double>& values) const {
  return gather_lists(values, MPI_DOUBLE, *this);
}

std::vector<long long> Communicator::gather(const std::vector<long long>& values) const {
  return gather_lists(values, MPI_LONG_LONG, *this);
}

void Communicator::barrier() const { MPI_Barrier(comm_); }

void Communicator::agree_on_input_error(const std::string& sentence) const {
  const std::string text = first_sentence(*this, sentence);
  if (!text.empty()) throw InputError(text);
}

}  // namespace perinox
