#pragma once
/// `checkpoint.h5`: all that a run goes on from. Layout: docs/restart.md.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/core/saved_state.hpp"
#include "perinox/output/checksum.hpp"

namespace perinox::output {

/// What a checkpoint says of itself.
struct CheckpointHead {
  int step = 0;
  double t = 0;
  std::string deck{};               ///< resolved, as YAML; names of its files start at its folder
  std::string files{};              ///< what the deck's files hold: see file_fingerprints()
  std::string perinox_version{};    ///< that has written it
  long long ranks = 0;              ///< that have written it
  long long history_bytes = 0;      ///< of history.csv up to this step
  long long convergence_bytes = 0;  ///< of convergence.csv
  long long phases = 0;             ///< in results.h5
  /// Within the step after `step`: its attempt in convergence.csv, from 1. 0: between steps.
  long long attempt = 0;
};

/// A number for the particles: ids, reference positions, volumes, bodies, materials. The same on any number of ranks.
/// Sixteen hexadecimal digits. Collective.
std::string body_fingerprint(const body::Body& body);

/// What the input files of a deck hold: a line each, "<key of the deck> <checksum>". Collective. Throws RunError if one
/// cannot be read.
std::string file_fingerprints(const deck::Deck& deck, const Communicator& communicator);

/// Writes checkpoints of one run to one path, each in the place of the last: to a temporary beside it, which is brought
/// to the disk and renamed. At every moment there is a whole checkpoint under the path, the last or the one before.
class CheckpointWriter {
 public:
  /// Writes nothing yet. Collective.
  CheckpointWriter(std::string path, const body::Body& body);
  ~CheckpointWriter();

  /// save is called twice: to find the size, for which room is set aside first, and to write. Collective. Throws
  /// RunError with path and reason if the disk refuses; the checkpoint before is untouched then.
  void write(const CheckpointHead& head, const std::function<void(StateWriter&)>& save);

  const std::string& path() const { return path_; }

 private:
  struct Plan;
  /// Returns what is known of the checksum.
  std::vector<KnownShare> fill(const CheckpointHead& head, const std::function<void(StateWriter&)>& save,
                               const std::string& temporary);
  /// Text for the beginning of the file, to the disk, rename.
  void seal(const std::string& temporary, const std::vector<KnownShare>& known);

  std::string path_;
  std::unique_ptr<Plan> plan_;
};

/// Reads the head of a checkpoint after every byte of the file has been compared with its checksum. Collective. Throws
/// InputError: no checkpoint, truncated, damaged, of another format.
CheckpointHead read_checkpoint_head(const std::string& path, const Communicator& communicator);

/// The state in a checkpoint that has passed read_checkpoint_head, for a body on any number of ranks.
class CheckpointReader : public StateReader {
 public:
  /// Collective. Throws InputError if it is of other particles.
  CheckpointReader(std::string path, const body::Body& body);
  ~CheckpointReader() override;

  bool has(const std::string& name) const override;
  double number(const std::string& name) const override;
  long long integer(const std::string& name) const override;
  std::string text(const std::string& name) const override;
  std::vector<double> particles(const std::string& name, int components) const override;
  std::vector<int> list_counts(const std::string& name) const override;
  void lists(const std::string& name, const Sink& sink) const override;
  void refuse_if(const std::string& sentence) const override;

 private:
  struct Plan;
  std::string path_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace perinox::output
