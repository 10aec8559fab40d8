#include "run_record.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "perinox/core/error.hpp"
#include "perinox/deck/declared.hpp"
#include "perinox/deck/key_forms.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::study {

namespace {
namespace fs = std::filesystem;

deck::Key record_key() {
  using deck::number_key;
  using deck::required;
  return deck::map_key("", "A finished run of a study.",
                       {required(deck::text_key("fingerprint", "Hash of the run's input and program.")),
                        required(deck::integer_key("status", 0, 255, "", "Exit status.")),
                        deck::text_key("reason", "Why it stopped short."),
                        required(number_key("cpu_seconds", "s", "User and system time of all ranks.")),
                        required(number_key("wall_seconds", "s", "Time on the clock.")),
                        required(number_key("peak_megabytes", "MB", "Memory of the largest process.")),
                        required(deck::integer_key("bonds", 0, 9e18, "", "Directed bonds."))});
}

/// FNV-1a hash of 64 bits. Large files are taken in words of eight bytes, because only equality matters.
class Hash {
 public:
  void add(const std::string& text) {
    for (const char c : text) mix(static_cast<unsigned char>(c));
    mix(text.size());
  }
  void add_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string block(1 << 20, '\0');
    while (file) {
      file.read(block.data(), static_cast<std::streamsize>(block.size()));
      const auto count = static_cast<std::size_t>(file.gcount());
      std::size_t i = 0;
      for (; i + 8 <= count; i += 8) {
        std::uint64_t word = 0;
        block.copy(reinterpret_cast<char*>(&word), 8, i);
        mix(word);
      }
      for (; i < count; ++i) mix(static_cast<unsigned char>(block[i]));
    }
  }
  std::string text() const { return fmt::format("h{:016x}", value_); }

 private:
  void mix(std::uint64_t word) { value_ = (value_ ^ word) * 1099511628211ULL; }
  std::uint64_t value_ = 14695981039346656037ULL;
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Hash of the program, taken once because the program does not change while it runs.
const std::string& program_hash() {
  static const std::string hash = [] {
    Hash own;
    own.add_file(own_path());
    return own.text();
  }();
  return hash;
}
}  // namespace

void write_record(const std::string& folder, const RunRecord& record) {
  const fs::path path = fs::path(folder) / "record.yaml", part = fs::path(folder) / "record.yaml.part";
  std::ofstream file(part, std::ios::binary);
  file << "fingerprint: " << record.fingerprint << "\nstatus: " << record.outcome.status << '\n';
  if (!record.reason.empty()) file << "reason: " << deck::quote(record.reason) << '\n';
  file << "cpu_seconds: " << deck::format_number(record.outcome.cpu_seconds) << '\n'
       << "wall_seconds: " << deck::format_number(record.outcome.wall_seconds) << '\n'
       << "peak_megabytes: " << deck::format_number(record.outcome.peak_megabytes) << '\n'
       << "bonds: " << record.bonds << '\n';
  file.close();
  if (!file || std::rename(part.c_str(), path.c_str()) != 0) throw RunError(path.string() + " cannot be written");
}

std::optional<RunRecord> read_record(const std::string& folder) {
  const std::string path = folder + "/record.yaml";
  if (!fs::is_regular_file(path)) return std::nullopt;
  try {
    const deck::Value value = deck::read_declared(path, record_key(), "record");
    RunRecord record;
    record.fingerprint = value.at("fingerprint").text();
    record.reason = value.has("reason") ? value.at("reason").text() : "";
    record.outcome.status = static_cast<int>(value.at("status").integer());
    record.outcome.cpu_seconds = value.at("cpu_seconds").number();
    record.outcome.wall_seconds = value.at("wall_seconds").number();
    record.outcome.peak_megabytes = value.at("peak_megabytes").number();
    record.bonds = value.at("bonds").integer();
    return record;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string fingerprint(const deck::Deck& deck, int ranks, int repetitions) {
  Hash hash;
  hash.add(deck::write_resolved(deck, deck::folder_of(deck.file)));
  for (const deck::InputFile& file : deck::input_files(deck)) hash.add_file(file.path);
  hash.add(fmt::format("{} {}", ranks, repetitions));
  hash.add(program_hash());
  return hash.text();
}

std::string reason_in(const std::string& error_file) {
  std::istringstream lines(text_of(error_file));
  std::string first, said;  // the last of what it says is why it ended
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("perinox: ", 0) == 0) said = line.substr(9);
    if (line.rfind("note: ", 0) == 0 || line.rfind("warning: ", 0) == 0) continue;
    if (first.empty()) first = line;
  }
  return said.empty() ? first : said;
}

bool was_told_to_stop(const std::string& reason) {
  for (const char* signal : {"SIGTERM", "SIGINT", "SIGUSR1"})
    if (reason.find(std::string(signal) + " was received") != std::string::npos) return true;
  return false;
}

long long bonds_in(const std::string& output_file) {
  std::istringstream lines(text_of(output_file));
  for (std::string line; std::getline(lines, line);) {
    long long bonds = 0;
    int end = 0;
    if (std::sscanf(line.c_str(), "  %lld directed bonds%n", &bonds, &end) == 1 && end > 0) return bonds;
  }
  return 0;
}

}  // namespace perinox::study
