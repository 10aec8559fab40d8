#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

#include "perinox/core/error.hpp"

namespace perinox::fuzz {

/// A refusal is one line that a terminal can show, and not endless.
inline void demand_sentence(const std::string& sentence) {
  constexpr std::size_t longest = 5000;
  if (sentence.empty()) throw std::logic_error("refused without a sentence");
  if (sentence.size() > longest) throw std::logic_error("refused with a sentence that does not end");
  for (const char c : sentence)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      throw std::logic_error("refused with a sentence that holds a control character");
}

/// The sentence of the last refusal.
inline std::string last_refusal;

/// True if `work` ends, false if it throws InputError with a sentence. Everything else passes through.
template <class Work>
bool accepted(Work&& work) {
  try {
    work();
    return true;
  } catch (const InputError& error) {
    last_refusal = error.what();
    demand_sentence(last_refusal);
    return false;
  }
}

/// Throws std::logic_error: perinox has accepted what it should not have.
inline void demand(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

/// A file of these bytes that exists in memory only.
class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("fuzz", 0)) {
    if (file_ < 0) throw std::runtime_error("no file in memory can be made");
  }
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  void put(const std::string& bytes) {
    const auto size = static_cast<ssize_t>(bytes.size());
    if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, bytes.data(), bytes.size(), 0) != size)
      throw std::runtime_error("the file in memory cannot be written");
  }
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

}  // namespace perinox::fuzz
