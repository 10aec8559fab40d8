#include "perinox/output/checkpoint.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

#include "../targets.hpp"
#include "accepted.hpp"
#include "fracture/broken_table.hpp"
#include "output/checkpoint_seal.hpp"
#include "output/hdf5_handle.hpp"
#include "perinox/core/restored.hpp"
#include "perinox/output/checksum.hpp"
#include "small_body.hpp"

namespace perinox::fuzz {

namespace {

/// The input's bytes one after the other, zeros behind its end.
class Bytes {
 public:
  Bytes(const std::string& input, std::size_t begin) : input_(input), next_(begin) {}
  std::uint8_t byte() { return next_ < input_.size() ? static_cast<std::uint8_t>(input_[next_++]) : std::uint8_t{0}; }
  template <class Number>
  Number number() {
    std::array<std::uint8_t, sizeof(Number)> raw{};
    for (std::uint8_t& one : raw) one = byte();
    Number value{};
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }
  std::string text() {
    std::string all;
    for (std::uint8_t left = byte() % 32; left > 0; --left) all += static_cast<char>(byte());
    return all;
  }

 private:
  const std::string& input_;
  std::size_t next_;
};

/// A file in memory with what CheckpointWriter writes, or a copy of it in which the objects are others that the bytes
/// ask for. A copy is opened with the first of them, since nothing costs as much as HDF5's opening of a file.
class Content {
 public:
  /// base: a whole file with all that is usual, seal included; empty: it is to be made.
  Content(Bytes& bytes, const std::string& base) : bytes_(bytes), base_(base) {
    text_ = H5Tcopy(H5T_C_S1);
    H5Tset_size(text_, H5T_VARIABLE);
    H5Tset_cset(text_, H5T_CSET_UTF8);
    if (base.empty()) open();
  }
  ~Content() {
    H5Tclose(text_);
    if (file_ >= 0) H5Fclose(file_);
  }
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;

  /// The whole file with a right seal.
  std::string sealed() const {
    if (file_ < 0) return base_;
    H5Fflush(file_, H5F_SCOPE_GLOBAL);
    const ssize_t size = H5Fget_file_image(file_, nullptr, 0);  // without the user block
    demand(size > 0, "HDF5 has no image of its file in memory");
    std::string image(static_cast<std::size_t>(size), '\0');
    demand(H5Fget_file_image(file_, image.data(), image.size()) > 0, "HDF5 gives no image of its file in memory");
    return output::seal_text(image.size() + output::seal_bytes, output::checksum(image.data(), image.size())) + image;
  }

  void group(const char* name) {
    if (base_.empty()) H5Gclose(H5Gcreate2(file_, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }
  void attribute(const char* owner, const char* name, long long value) {
    if (usual() && base_.empty()) one(owner, name, H5T_NATIVE_LLONG, 1, &value, true);
  }
  void attribute(const char* owner, const char* name, double value) {
    if (usual() && base_.empty()) one(owner, name, H5T_NATIVE_DOUBLE, 1, &value, true);
  }
  void attribute(const char* owner, const char* name, const std::string& value) {
    const char* text = value.c_str();
    if (usual() && base_.empty()) one(owner, name, text_, 1, &text, true);
  }
  /// Replaces the attribute that comes next, if the bytes say so.
  void odd(const char* owner, const char* name) {
    open();
    H5Adelete_by_name(file_, owner, name, H5P_DEFAULT);
    const std::string made = bytes_.text();
    const char* texts[3] = {made.c_str(), "b", "c"};
    const auto real = bytes_.number<double>();
    const auto whole = bytes_.number<long long>();
    const std::array<long long, 10> many{whole, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    switch (bytes_.byte() % 8) {
      case 0:
        return one(owner, name, H5T_NATIVE_LLONG, 1, &whole, true);
      case 1:
        return one(owner, name, H5T_NATIVE_DOUBLE, 1, &real, true);
      case 2:
        return one(owner, name, H5T_NATIVE_LLONG, many.size(), many.data(), false);
      case 3:
        return one(owner, name, text_, 1, texts, true);
      case 4:
        return one(owner, name, text_, 3, texts, false);
      case 5:
        return one(owner, name, H5T_C_S1, 1, "x", true);
      case 6:
        return one(owner, name, H5T_NATIVE_LLONG, 0, nullptr, false);
      default:
        return;  // missing
    }
  }
  /// values: [rows * columns]; columns 0: a list.
  void table(const char* name, std::vector<double> values, hsize_t rows, hsize_t columns, hid_t type) {
    hsize_t extent[2] = {rows, columns};
    int dimensions = columns == 0 ? 1 : 2;
    hid_t stored = type;
    if (usual()) {
      if (!base_.empty()) return;
    } else {
      open();
      H5Ldelete(file_, name, H5P_DEFAULT);
      if (bytes_.byte() % 4 == 0) return;
      extent[0] = bytes_.byte() % 16;
      extent[1] = bytes_.byte() % 4;
      dimensions = bytes_.byte() % 3;
      stored = bytes_.byte() % 2 == 0 ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE;
      values.assign(64, 0);
      for (std::uint8_t k = 0, n = bytes_.byte() % 64; k < n; ++k)
        values[k] = stored == H5T_NATIVE_INT64 ? bytes_.number<std::int32_t>() : bytes_.number<double>();
    }
    const hid_t space = dimensions == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(dimensions, extent, nullptr);
    const hid_t table = H5Dcreate2(file_, name, stored, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (table >= 0) {
      H5Dwrite(table, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      H5Dclose(table);
    }
    H5Sclose(space);
  }
  /// Whether the next object is as it should be.
  bool usual() {
    const bool yes = !odd_;
    odd_ = false;
    return yes;
  }
  void choose() {
    constexpr std::uint8_t rarely = 224;
    odd_ = bytes_.byte() >= rarely;
  }
  bool is_odd() const { return odd_; }

 private:
  void open() {
    if (file_ >= 0) return;
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    constexpr std::size_t increment = 1 << 14;
    H5Pset_fapl_core(access, increment, 0);
    if (base_.empty()) {
      const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
      H5Pset_userblock(creation, output::seal_bytes);
      file_ = H5Fcreate("fuzz.h5", H5F_ACC_TRUNC, creation, access);
      H5Pclose(creation);
    } else {
      std::string copy = base_;
      H5Pset_file_image(access, copy.data(), copy.size());
      file_ = H5Fopen("fuzz.h5", H5F_ACC_RDWR, access);
    }
    H5Pclose(access);
    demand(file_ >= 0, "HDF5 opens no file in memory");
  }
  void one(const char* owner, const char* name, hid_t type, std::size_t count, const void* value, bool scalar) {
    const hsize_t extent = count;
    const hid_t space = count == 0 ? H5Screate(H5S_NULL)
                        : scalar   ? H5Screate(H5S_SCALAR)
                                   : H5Screate_simple(1, &extent, nullptr);
    const hid_t object = H5Oopen(file_, owner, H5P_DEFAULT);
    const hid_t made = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    if (value != nullptr) H5Awrite(made, type, value);
    H5Aclose(made);
    H5Oclose(object);
    H5Sclose(space);
  }

  Bytes& bytes_;
  const std::string& base_;
  hid_t file_ = -1, text_ = -1;
  bool odd_ = false;
};

template <class Value>
void put(Content& content, const char* owner, const char* name, const Value& value) {
  content.choose();
  if (content.is_odd()) content.odd(owner, name);
  content.attribute(owner, name, value);
}

/// A whole checkpoint file with a right seal.
std::string made_of(Bytes& bytes, const body::Body& body, const std::string& base) {
  const output::Silence silence;  // what is asked for may be more than HDF5 gives
  Content content(bytes, base);
  put(content, "/", "deck", std::string("title: fuzz\n"));
  put(content, "/", "perinox_version", std::string(PERINOX_VERSION));
  for (const char* name : {"step", "ranks", "history_bytes", "convergence_bytes", "phases", "attempt"})
    put(content, "/", name, 1LL);
  put(content, "/", "t", 0.5);
  put(content, "/", "particles", static_cast<long long>(body.total));
  put(content, "/", "body_hash", output::body_fingerprint(body));
  content.group("/a");
  put(content, "/a", "integer", 7LL);
  put(content, "/a", "number", 0.1);
  put(content, "/a", "text", std::string("words"));
  const auto particles = static_cast<hsize_t>(body.total);
  content.choose();
  content.table("/a/field", std::vector<double>(2 * particles, 0.5), particles, 2, H5T_NATIVE_DOUBLE);
  content.group("/a/lists");
  content.choose();
  content.table("/a/lists/count", std::vector<double>(particles, 2), particles, 0, H5T_NATIVE_INT);
  content.choose();
  content.table("/a/lists/values", std::vector<double>(2 * particles, 1), 2 * particles, 0, H5T_NATIVE_DOUBLE);
  // Broken bonds: of particle 0 to 1 in round 0, and to 3 in round 1; the second had flowed.
  content.group("/fracture");
  content.group("/fracture/broken");
  content.choose();
  content.table("/fracture/broken/count", {4, 0, 0, 0, 0, 0, 0, 0}, particles, 0, H5T_NATIVE_INT);
  content.choose();
  content.table("/fracture/broken/values", {1, 0, 3, 1}, 4, 0, H5T_NATIVE_DOUBLE);
  content.group("/fracture/broken_extension");
  content.choose();
  constexpr double size = fracture::broken_extension_size;
  content.table("/fracture/broken_extension/count", {size, 0, 0, size, 0, 0, 0, 0}, particles, 0, H5T_NATIVE_INT);
  content.choose();
  content.table("/fracture/broken_extension/values", std::vector<double>(2 * fracture::broken_extension_size, 0.1),
                2 * fracture::broken_extension_size, 0, H5T_NATIVE_DOUBLE);
  return content.sealed();
}

/// One file on a tmpfs, of this process alone, gone at its end. HDF5 opens no file that has no path.
class ScratchFile {
 public:
  ScratchFile() : path_("/dev/shm/perinox-fuzz-" + std::to_string(::getpid())) {}
  ~ScratchFile() { ::unlink(path_.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  void put(const std::string& bytes) const {
    std::ofstream file(path_, std::ios::binary);
    demand(static_cast<bool>(file << bytes), "the file in /dev/shm cannot be written");
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

void demand_finite(const std::vector<double>& values) {
  for (const double value : values) demand(std::isfinite(value), "a state with a number that is not finite");
}

/// What the rest of the program builds on without looking again.
void demand_bonds(const std::vector<fracture::BrokenEntry>& table, const body::Body& body) {
  std::set<std::pair<long long, long long>> seen;
  for (const auto& [lower, upper, round] : table) {
    demand(lower >= 0 && lower < upper && upper < body.total, "a broken bond of particles that are not there");
    demand(round >= 0 && round < static_cast<long long>(table.size()), "more rounds than broken bonds");
    demand(seen.insert({lower, upper}).second, "a bond that is broken twice");
  }
}

bool read_back(const std::string& path, const body::Body& body) {
  output::CheckpointHead head;
  if (!accepted([&] { head = output::read_checkpoint_head(path, body.communicator); })) return false;
  demand(head.step >= 0 && head.phases >= 0 && head.history_bytes >= 0 && head.convergence_bytes >= 0 &&
             head.ranks >= 0 && head.attempt >= 0 && head.t >= 0 && std::isfinite(head.t),
         "a head with numbers below zero");
  return accepted([&] {
    const output::CheckpointReader reader(path, body);
    for (const char* name : {"a/integer", "a/number", "a/text", "a/field", "b/c"}) reader.has(name);
    const auto count = static_cast<std::size_t>(body.owned);
    const std::vector<double> field = reader.particles("a/field", 2);
    demand(field.size() == 2 * count, "a field of another size");
    demand_finite(field);
    std::size_t listed = 0, received = 0;
    for (const int length : reader.list_counts("a/lists")) {
      demand(length >= 0, "a list of negative length");
      listed += static_cast<std::size_t>(length);
    }
    reader.lists("a/lists", [&](const std::vector<LocalIndex>&, const std::vector<double>& values) {
      demand_finite(values);
      received += values.size();
    });
    demand(listed == received, "lists of other lengths than they say");
    demand_bonds(fracture::read_broken_table(body, reader), body);
    const std::vector<bonds::BrokenExtension> extension = fracture::read_broken_extension(reader);
    demand(extension.empty() || extension.size() == count, "another number of particles with broken bonds");
    reader.integer("a/integer");
    const int whole = restored_count(reader, "a/integer", 1000);
    demand(whole >= 0 && whole <= 1000, "a count outside its bounds");
    demand_finite({reader.number("a/number")});
    demand(restored_number(reader, "a/number", 0) >= 0, "a number below its bound");
    reader.text("a/text");
  });
}

}  // namespace

bool checkpoint(const std::string& input) {
  // HDF5 keeps the half megabyte that it takes for every open file, and need not ask for it again.
  static const herr_t kept = H5set_free_list_limits(-1, -1, -1, -1, -1, -1);
  demand(kept >= 0, "HDF5 does not take the limits of its free lists");
  static const ScratchFile file;
  const body::Body body = small_body(3);
  const std::string none;
  Bytes nothing(none, 0), bytes(input, 1);
  static const std::string usual = made_of(nothing, body, none);
  if (input.empty()) return false;
  file.put(input[0] == 'F' ? input.substr(1) : made_of(bytes, body, usual));
  return read_back(file.path(), body);
}

}  // namespace perinox::fuzz
