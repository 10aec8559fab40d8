#include "perinox/output/checkpoint.hpp"

#include <hdf5.h>

#include <array>
#include <cstring>
#include <fstream>

#include "../targets.hpp"
#include "accepted.hpp"
#include "checkpoint_seal.hpp"
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

/// Writes what CheckpointWriter writes, as long as the bytes do not ask for something else.
class Content {
 public:
  Content(const std::string& path, Bytes& bytes) : bytes_(bytes) {
    const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(creation, output::seal_bytes);
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT);
    H5Pclose(creation);
    text_ = H5Tcopy(H5T_C_S1);
    H5Tset_size(text_, H5T_VARIABLE);
    H5Tset_cset(text_, H5T_CSET_UTF8);
  }
  ~Content() {
    H5Tclose(text_);
    H5Fclose(file_);
  }
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;

  void group(const char* name) { H5Gclose(H5Gcreate2(file_, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)); }
  void attribute(const char* owner, const char* name, long long value) {
    if (usual()) one(owner, name, H5T_NATIVE_LLONG, 1, &value, true);
  }
  void attribute(const char* owner, const char* name, double value) {
    if (usual()) one(owner, name, H5T_NATIVE_DOUBLE, 1, &value, true);
  }
  void attribute(const char* owner, const char* name, const std::string& value) {
    const char* text = value.c_str();
    if (usual()) one(owner, name, text_, 1, &text, true);
  }
  /// Replaces the attribute that comes next, if the bytes say so.
  void odd(const char* owner, const char* name) {
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
    if (!usual()) {
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
  hid_t file_ = -1, text_ = -1;
  bool odd_ = false;
};

template <class Value>
void put(Content& content, const char* owner, const char* name, const Value& value) {
  content.choose();
  if (content.is_odd()) content.odd(owner, name);
  content.attribute(owner, name, value);
}

void write_content(const std::string& path, Bytes& bytes, const body::Body& body) {
  Content content(path, bytes);
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
}

void seal(const std::string& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  std::string all{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::uint64_t sum = output::checksum(all.data() + output::seal_bytes, all.size() - output::seal_bytes);
  file.clear();
  file.seekp(0);
  file << output::seal_text(all.size(), sum);
}

bool read_back(const std::string& path, const body::Body& body) {
  output::CheckpointHead head;
  if (!accepted([&] { head = output::read_checkpoint_head(path, body.communicator); })) return false;
  demand(head.step >= 0 && head.phases >= 0 && head.history_bytes >= 0, "a head with negative numbers");
  return accepted([&] {
    const output::CheckpointReader reader(path, body);
    for (const char* name : {"a/integer", "a/number", "a/text", "a/field", "b/c"}) reader.has(name);
    const auto count = static_cast<std::size_t>(body.owned);
    demand(reader.particles("a/field", 2).size() == 2 * count, "a field of another size");
    std::size_t listed = 0, received = 0;
    for (const int length : reader.list_counts("a/lists")) {
      demand(length >= 0, "a list of negative length");
      listed += static_cast<std::size_t>(length);
    }
    reader.lists("a/lists",
                 [&](const std::vector<LocalIndex>&, const std::vector<double>& v) { received += v.size(); });
    demand(listed == received, "lists of other lengths than they say");
    reader.integer("a/integer");
    reader.number("a/number");
    reader.text("a/text");
  });
}

}  // namespace

bool checkpoint(const std::string& input) {
  static const std::string path = "/dev/shm/perinox-fuzz-" + std::to_string(::getpid());
  const body::Body body = small_body(3);
  if (input.empty()) return false;
  if (input[0] == 'F') {
    std::ofstream(path, std::ios::binary) << input.substr(1);
  } else {
    Bytes bytes(input, 1);
    write_content(path, bytes, body);
    seal(path);
  }
  const bool good = read_back(path, body);
  ::unlink(path.c_str());
  return good;
}

}  // namespace perinox::fuzz
