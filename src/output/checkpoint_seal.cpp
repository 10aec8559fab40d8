#include "checkpoint_seal.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "perinox/output/checksum.hpp"

namespace perinox::output {

namespace {
constexpr const char* title = "perinox checkpoint\n";

/// The word behind a name at the beginning of a line.
std::string word_after(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("\n" + name + " ");
  if (at == std::string::npos) return "";
  const std::size_t begin = at + name.size() + 2;
  return text.substr(begin, text.find('\n', begin) - begin);
}
}  // namespace

std::string seal_text(std::uint64_t bytes, std::uint64_t checksum, int format) {
  std::string text = fmt::format("{}format {}\nbytes {}\nchecksum {}\n", title, format, bytes, hexadecimal(checksum));
  text.resize(seal_bytes, '\n');
  return text;
}

std::string read_seal(const std::string& path, const std::string& head, std::uint64_t bytes, std::uint64_t& checksum) {
  if (head.rfind(title, 0) != 0)
    return fmt::format(
        "{} is no checkpoint of perinox, or its beginning is damaged; --restart takes the file "
        "checkpoint.h5 of a run",
        path);
  const std::string format = word_after(head, "format"), length = word_after(head, "bytes");
  checksum = std::strtoull(word_after(head, "checksum").c_str(), nullptr, 16);
  const std::uint64_t told = std::strtoull(length.c_str(), nullptr, 10);
  if (told > bytes)
    return fmt::format("{} is truncated: {} bytes of {} are there; take a copy that is whole, or start the run anew",
                       path, bytes, told);
  const int number = std::atoi(format.c_str());
  if (number != checkpoint_format && told == bytes && head == seal_text(told, checksum, number))
    return fmt::format("{} has format {}, this perinox reads format {}", path, number, checkpoint_format);
  if (told != bytes || head != seal_text(told, checksum))
    return fmt::format(
        "{} is damaged: its first lines are not as they were written; take a copy that is whole, or "
        "start the run anew",
        path);
  return "";
}

}  // namespace perinox::output
