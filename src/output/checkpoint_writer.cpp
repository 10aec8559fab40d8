#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <set>

#include "agree.hpp"
#include "checkpoint_seal.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/output/checkpoint.hpp"
#include "perinox/output/checksum.hpp"
#include "reserve.hpp"
#include "row_lists.hpp"

namespace perinox::output {

struct CheckpointWriter::Plan {
  explicit Plan(const body::Body& body)
      : communicator(body.communicator),
        order(body.communicator, body.id, body.owned, body.total),
        lists(body, order),
        fingerprint(body_fingerprint(body)) {}
  Communicator communicator;
  RowOrder order;
  RowLists lists;
  std::string fingerprint;
};

namespace {

/// Adds up the bytes of what would be written.
class Counting : public StateWriter {
 public:
  explicit Counting(const Communicator& communicator) : communicator_(communicator) {}
  void number(const std::string&, double) override { bytes_ += overhead; }
  void integer(const std::string&, long long) override { bytes_ += overhead; }
  void text(const std::string&, const std::string& value) override {
    bytes_ += overhead + static_cast<double>(value.size());
  }
  void particles(const std::string&, const double*, int components) override {
    bytes_ += overhead + block;
    columns_ += components;
  }
  void lists(const std::string&, const std::vector<int>& count, const Source&) override {
    bytes_ += 2 * overhead + 2 * block;
    columns_ += 0.5;
    for (const int length : count) mine_ += length;
  }
  double bytes(GlobalId particles) const {
    return bytes_ + 8 * (columns_ * static_cast<double>(particles) + communicator_.sum(mine_));
  }

 private:
  static constexpr double overhead = 1024;  ///< ample bound on HDF5's own bytes for an object
  static constexpr double block = 512;      ///< datasets begin at a multiple of it
  Communicator communicator_;
  double bytes_ = 0, columns_ = 0, mine_ = 0;
};

class Writing : public StateWriter {
 public:
  Writing(ParallelFile& file, const RowOrder& order, const RowLists& lists)
      : file_(file), order_(order), lists_(lists) {}
  void number(const std::string& name, double value) override {
    file_.set_attribute(group_of(name), leaf_of(name), value);
  }
  void integer(const std::string& name, long long value) override {
    file_.set_attribute(group_of(name), leaf_of(name), static_cast<GlobalId>(value));
  }
  void text(const std::string& name, const std::string& value) override {
    file_.set_attribute(group_of(name), leaf_of(name), value);
  }
  void particles(const std::string& name, const double* values, int components) override {
    group_of(name);
    file_.write_rows("/" + name, order_.to_rows(values, components), order_.total(), order_.first_row(), components);
  }
  void lists(const std::string& name, const std::vector<int>& count, const Source& source) override {
    group_of(name + "/count");
    lists_.write(file_, "/" + name, count, source);
  }

 private:
  /// The group of a name. It is made, with all the groups above it, when it is first mentioned.
  std::string group_of(const std::string& name) {
    for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1)) {
      const std::string group = "/" + name.substr(0, slash);
      if (groups_.insert(group).second) file_.make_group(group);
    }
    return "/" + name.substr(0, name.rfind('/'));
  }
  static std::string leaf_of(const std::string& name) { return name.substr(name.rfind('/') + 1); }

  ParallelFile& file_;
  const RowOrder& order_;
  const RowLists& lists_;
  std::set<std::string> groups_;
};

/// Writes the seal, brings all to the disk and renames the file. Returns "" or the reason.
std::string finish(const std::string& temporary, const std::string& path, const std::string& seal) {
  const int file = ::open(temporary.c_str(), O_WRONLY);
  bool done = file >= 0 && ::pwrite(file, seal.data(), seal.size(), 0) == static_cast<ssize_t>(seal.size()) &&
              ::fsync(file) == 0;
  std::string reason = done ? "" : std::strerror(errno);
  if (file >= 0) ::close(file);
  if (!done) return reason;
  if (std::rename(temporary.c_str(), path.c_str()) != 0) return std::strerror(errno);
  const std::filesystem::path directory = std::filesystem::path(path).parent_path();
  return sync_to_disk(directory.empty() ? "." : directory.string());
}

}  // namespace

std::string body_fingerprint(const body::Body& body) {
  constexpr std::uint64_t words = 8;
  std::uint64_t sum = 0;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    const deck::Point x = body.position3(i);
    const std::array<double, words> values{
        static_cast<double>(body.id[i]),       x[0], x[1], x[2], body.volume[i], static_cast<double>(body.part[i]),
        static_cast<double>(body.material[i]), 0};
    sum += checksum(values.data(), sizeof values, static_cast<std::uint64_t>(body.id[i]) * words);
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, body.communicator.mpi());
  return hexadecimal(sum);
}

std::string file_fingerprints(const deck::Deck& deck, const Communicator& communicator) {
  std::string lines;
  for (const deck::InputFile& file : deck::input_files(deck)) {
    std::error_code ignored;
    const auto bytes = static_cast<std::uint64_t>(
        communicator.max(static_cast<long long>(std::filesystem::file_size(file.path, ignored))));
    lines += fmt::format("{} {}\n", file.key, hexadecimal(file_checksum(file.path, 0, bytes, communicator)));
  }
  return lines;
}

CheckpointWriter::CheckpointWriter(std::string path, const body::Body& body)
    : path_(std::move(path)), plan_(std::make_unique<Plan>(body)) {}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::write(const CheckpointHead& head, const std::function<void(StateWriter&)>& save) {
  const Communicator& communicator = plan_->communicator;
  const std::string temporary = path_ + ".part";
  try {
    seal(temporary, fill(head, save, temporary));
  } catch (const RunError& error) {
    if (communicator.is_root()) ::unlink(temporary.c_str());
    throw RunError(fmt::format("the checkpoint of step {} cannot be written, the last one is left as it is: {}",
                               head.step, error.what()));
  }
}

std::vector<KnownShare> CheckpointWriter::fill(const CheckpointHead& head,
                                               const std::function<void(StateWriter&)>& save,
                                               const std::string& temporary) {
  const Communicator& communicator = plan_->communicator;
  Counting counting(communicator);
  save(counting);
  const double bytes =
      counting.bytes(plan_->order.total()) + static_cast<double>(head.deck.size() + head.files.size()) + 64 * 1024;
  ParallelFile file(temporary, communicator, ParallelFile::Mode::create, seal_bytes);
  agree_on_run_error(communicator, communicator.is_root() ? reserve(temporary, bytes) : std::string());
  file.set_attribute("/", "deck", head.deck);
  file.set_attribute("/", "deck_hash", hexadecimal(checksum(head.deck.data(), head.deck.size())));
  file.set_attribute("/", "files", head.files);
  file.set_attribute("/", "perinox_version", std::string(PERINOX_VERSION));
  file.set_attribute("/", "step", static_cast<GlobalId>(head.step));
  file.set_attribute("/", "t", head.t);
  file.set_attribute("/", "ranks", static_cast<GlobalId>(communicator.size()));
  file.set_attribute("/", "particles", plan_->order.total());
  file.set_attribute("/", "body_hash", plan_->fingerprint);
  file.set_attribute("/", "history_bytes", static_cast<GlobalId>(head.history_bytes));
  file.set_attribute("/", "convergence_bytes", static_cast<GlobalId>(head.convergence_bytes));
  file.set_attribute("/", "phases", static_cast<GlobalId>(head.phases));
  file.set_attribute("/", "attempt", static_cast<GlobalId>(head.attempt));
  Writing writing(file, plan_->order, plan_->lists);
  save(writing);
  file.close();
  return file.filled();
}

void CheckpointWriter::seal(const std::string& temporary, const std::vector<KnownShare>& known) {
  const Communicator& communicator = plan_->communicator;
  std::error_code ignored;
  const std::uint64_t bytes = std::filesystem::file_size(temporary, ignored);
  const std::uint64_t sum = file_checksum(temporary, seal_bytes, bytes, communicator, known);
  // On another machine than rank 0's, the rank's own system has to bring to the disk what the rank has written.
  std::string reason = communicator.size() > 1 && !communicator.is_root() ? sync_to_disk(temporary) : "";
  agree_on_run_error(communicator, reason.empty() ? "" : temporary + " could not be brought to the disk: " + reason);
  if (communicator.is_root()) reason = finish(temporary, path_, seal_text(bytes, sum));
  agree_on_run_error(communicator, reason.empty() ? "" : path_ + " could not be brought to the disk: " + reason);
}

}  // namespace perinox::output
