#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "checkpoint_seal.hpp"
#include "not_finite.hpp"
#include "perinox/core/error.hpp"
#include "perinox/output/checkpoint.hpp"
#include "perinox/output/checksum.hpp"
#include "row_lists.hpp"

namespace perinox::output {

namespace {

/// Runs `work` and makes every failure of HDF5 an error of the input.
template <class Work>
auto as_input(Work&& work) {
  try {
    return work();
  } catch (const RunError& error) {
    throw InputError(error.what());
  }
}

std::string group_of(const std::string& name) { return "/" + name.substr(0, name.rfind('/')); }
std::string leaf_of(const std::string& name) { return name.substr(name.rfind('/') + 1); }

/// Rank 0's look at the file: the sentence that says why it is not whole, its length and the checksum that it must
/// have.
std::string first_look(const std::string& path, std::uint64_t& bytes, std::uint64_t& wanted) {
  std::error_code error;
  bytes = std::filesystem::file_size(path, error);
  if (error) return fmt::format("{} cannot be read: {}", path, error.message());
  std::ifstream file(path, std::ios::binary);
  std::string head(seal_bytes, '\0');
  file.read(head.data(), seal_bytes);
  head.resize(static_cast<std::size_t>(file.gcount()));
  return read_seal(path, head, bytes, wanted);
}

}  // namespace

CheckpointHead read_checkpoint_head(const std::string& path, const Communicator& communicator) {
  std::array<std::uint64_t, 2> look{0, 0};
  std::string sentence;
  if (communicator.is_root()) sentence = first_look(path, look[0], look[1]);
  communicator.agree_on_input_error(sentence);
  MPI_Bcast(look.data(), 2, MPI_UINT64_T, 0, communicator.mpi());
  return as_input([&] {
    const std::uint64_t found = file_checksum(path, seal_bytes, look[0], communicator);
    if (found != look[1])
      throw InputError(
          fmt::format("{} is damaged: its content has the checksum {}, {} was written; take a copy that is "
                      "whole, or start the run anew",
                      path, hexadecimal(found), hexadecimal(look[1])));
    const ParallelFile file(path, communicator, ParallelFile::Mode::read);
    CheckpointHead head;
    const auto count = [&](const char* name, long long most = std::numeric_limits<long long>::max()) {
      const long long value = file.integer_attribute("/", name);
      if (value < 0 || value > most) throw InputError(fmt::format("{} is damaged: its {} is {}", path, name, value));
      return value;
    };
    constexpr long long most_steps = std::numeric_limits<int>::max();
    head.step = static_cast<int>(count("step", most_steps));
    head.t = file.number_attribute("/", "t");
    if (!(std::isfinite(head.t) && head.t >= 0))
      throw InputError(fmt::format("{} is damaged: its t is {}", path, head.t));
    head.deck = file.text_attribute("/", "deck");
    if (file.has_attribute("/", "files")) head.files = file.text_attribute("/", "files");
    head.perinox_version = file.text_attribute("/", "perinox_version");
    head.ranks = count("ranks");
    head.history_bytes = count("history_bytes");
    head.convergence_bytes = count("convergence_bytes");
    head.phases = count("phases", most_steps);
    head.attempt = count("attempt", most_steps);
    return head;
  });
}

struct CheckpointReader::Plan {
  Plan(const std::string& path, const body::Body& body)
      : communicator(body.communicator),
        order(body.communicator, body.id, body.owned, body.total),
        lists(body, order),
        file(path, body.communicator, ParallelFile::Mode::read) {}
  Communicator communicator;
  RowOrder order;
  RowLists lists;
  ParallelFile file;
  /// The name whose lengths were asked for last. Whoever takes lists has asked for their lengths before.
  std::string counted;
  std::vector<int> count;

  const std::vector<int>& counts(const std::string& name) {
    if (counted == name) return count;
    counted.clear();
    count = lists.read_counts(file, "/" + name);
    counted = name;
    return count;
  }
};

CheckpointReader::CheckpointReader(std::string path, const body::Body& body) : path_(std::move(path)) {
  as_input([&] { plan_ = std::make_unique<Plan>(path_, body); });
  const std::string fingerprint = body_fingerprint(body);
  as_input([&] {
    const GlobalId particles = plan_->file.integer_attribute("/", "particles");
    if (particles != body.total)
      throw InputError(fmt::format("{} is of {} particles, the deck makes {}", path_, particles, body.total));
    if (plan_->file.text_attribute("/", "body_hash") != fingerprint)
      throw InputError(fmt::format(
          "{} is of particles at other places, of other volumes or other materials than the deck makes now; has a file "
          "that the deck reads changed?",
          path_));
  });
}

CheckpointReader::~CheckpointReader() = default;

bool CheckpointReader::has(const std::string& name) const {
  // HDF5 needs every group on the way to exist.
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1))
    if (!plan_->file.has("/" + name.substr(0, slash))) return false;
  return plan_->file.has("/" + name) || plan_->file.has_attribute(group_of(name), leaf_of(name));
}

double CheckpointReader::number(const std::string& name) const {
  return as_input([&] {
    const double value = plan_->file.number_attribute(group_of(name), leaf_of(name));
    refuse_not_finite(plan_->communicator, {value}, path_, name);
    return value;
  });
}

long long CheckpointReader::integer(const std::string& name) const {
  return as_input([&] { return plan_->file.integer_attribute(group_of(name), leaf_of(name)); });
}

std::string CheckpointReader::text(const std::string& name) const {
  return as_input([&] { return plan_->file.text_attribute(group_of(name), leaf_of(name)); });
}

std::vector<double> CheckpointReader::particles(const std::string& name, int components) const {
  const RowOrder& order = plan_->order;
  return as_input([&] {
    const auto rows = plan_->file.read_rows("/" + name, order.total(), order.first_row(), order.rows(), components);
    refuse_not_finite(plan_->communicator, rows, path_, name);
    return order.to_owners(rows.data(), components);
  });
}

std::vector<int> CheckpointReader::list_counts(const std::string& name) const {
  return as_input([&] { return plan_->counts(name); });
}

void CheckpointReader::lists(const std::string& name, const Sink& sink) const {
  as_input([&] {
    const std::vector<int> count = plan_->counts(name);
    plan_->lists.read(plan_->file, "/" + name, count, sink);
  });
}

void CheckpointReader::refuse_if(const std::string& sentence) const {
  plan_->communicator.agree_on_input_error(sentence.empty() ? sentence : path_ + " does not fit: " + sentence);
}

}  // namespace perinox::output
