#pragma once
/// Reads and writes `checkpoint.h5`, which holds all that a run needs to go on. Its layout is in docs/restart.md.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/core/saved_state.hpp"
#include "perinox/output/checksum.hpp"

namespace perinox::output {

/// What a checkpoint says about itself.
struct CheckpointHead {
  int step = 0;
  double t = 0;
  std::string deck{};               ///< resolved deck as YAML; names of its files count from its folder
  std::string files{};              ///< checksums of the deck's files: see file_fingerprints()
  std::string perinox_version{};    ///< version that has written it
  long long ranks = 0;              ///< number of ranks that have written it
  long long history_bytes = 0;      ///< length of history.csv up to this step
  long long convergence_bytes = 0;  ///< length of convergence.csv up to this step
  long long phases = 0;             ///< number of phases in results.h5
  /// Within the step after `step`: number of its attempt in convergence.csv, from 1. It is 0 between steps.
  long long attempt = 0;
};

/// A number that identifies the particles: their ids, reference positions, volumes, bodies and materials. It is the
/// same on any number of ranks. Sixteen hexadecimal digits. Collective.
std::string body_fingerprint(const body::Body& body);

/// Identifies the contents of a deck's input files, with one line for each: "<key of the deck> <checksum>". Collective.
/// Throws RunError if one cannot be read.
std::string file_fingerprints(const deck::Deck& deck, const Communicator& communicator);

/// Writes the checkpoints of one run to one path, each in the place of the last. A checkpoint is written to a temporary
/// file beside it, which is brought to the disk and renamed. At every moment there is a whole checkpoint under the
/// path, the last or the one before.
class CheckpointWriter {
 public:
  /// Does not write anything yet. Collective.
  CheckpointWriter(std::string path, const body::Body& body);
  ~CheckpointWriter();

  /// Writes a checkpoint. `save` is called twice: once to find the size, for which room is set aside first, and once to
  /// write. Collective. Throws RunError with path and reason if the disk refuses; the checkpoint before is then
  /// untouched.
  void write(const CheckpointHead& head, const std::function<void(StateWriter&)>& save);

  const std::string& path() const { return path_; }

 private:
  struct Plan;
  /// Writes the state into `temporary`. Returns what is known of the checksum.
  std::vector<KnownShare> fill(const CheckpointHead& head, const std::function<void(StateWriter&)>& save,
                               const std::string& temporary);
  /// Puts the seal at the beginning of the file, brings the file to the disk and renames it.
  void seal(const std::string& temporary, const std::vector<KnownShare>& known);

  std::string path_;
  std::unique_ptr<Plan> plan_;
};

/// Reads the head of a checkpoint after every byte of the file has been compared with its checksum. Collective. Throws
/// InputError if the file is no checkpoint, is truncated or damaged, or has another format.
CheckpointHead read_checkpoint_head(const std::string& path, const Communicator& communicator);

/// Reads the state in a checkpoint that has passed read_checkpoint_head, for a body on any number of ranks.
class CheckpointReader : public StateReader {
 public:
  /// Opens the checkpoint. Collective. Throws InputError if it is one of other particles.
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
