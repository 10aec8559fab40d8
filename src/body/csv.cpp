#include "perinox/body/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "perinox/deck/read.hpp"

namespace perinox::body {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

void trim(const char*& begin, const char*& end) {
  while (begin < end && is_blank(*begin)) ++begin;
  while (end > begin && is_blank(end[-1])) --end;
}

/// The text of a field as a message shows it: short and printable.
std::string shown(const char* begin, const char* end) {
  if (begin == end) return "an empty field";
  std::string text(begin, std::min(end, begin + 40));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text + (end - begin > 40 ? "..." : "");
}

std::string read_file(const std::string& path, const deck::Location& asked_at, const std::string& kind) {
  const auto refuse = [&](const char* why) {
    deck::refuse(asked_at,
                 fmt::format("cannot read {} as {}: {}; check the path, which is relative to the deck's folder", path,
                             kind, why));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) refuse(std::strerror(errno));
  std::string text;
  for (std::size_t size = 0, piece = 1 << 14;; piece = std::max(piece, size)) {
    text.resize(size + piece);
    const std::size_t got = std::fread(&text[size], 1, piece, file.get());
    size += got;
    if (got == piece) continue;
    if (std::ferror(file.get())) refuse(std::strerror(errno));
    text.resize(size);
    return text;
  }
}

}  // namespace

CsvTable::CsvTable(const std::string& path, const deck::Location& asked_at, const CsvColumns& columns)
    : file_(path), text_(read_file(path, asked_at, columns.kind)) {
  parse(columns);
}

CsvTable CsvTable::from_text(std::string text, const std::string& file, const CsvColumns& columns) {
  CsvTable table;
  table.file_ = file;
  table.text_ = std::move(text);
  table.parse(columns);
  return table;
}

void CsvTable::refuse_at(const char* place, const std::string& sentence) const {
  deck::refuse({file_, static_cast<int>(line_number_), static_cast<int>(place - line_start_) + 1}, sentence);
}

std::size_t CsvTable::index(const std::string& name) const {
  return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
}

std::size_t CsvTable::column(const std::string& name) const {
  if (!has(name)) throw std::logic_error(fmt::format("{} has no column {}", file_, name));
  return index(name);
}

void CsvTable::parse(const CsvColumns& columns) {
  const char* position = text_.data();
  const char* const end = position + text_.size();
  if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) position += 3;
  while (position < end) {
    ++line_number_;
    line_start_ = position;
    const auto* line_end =
        static_cast<const char*>(std::memchr(position, '\n', static_cast<std::size_t>(end - position)));
    if (!line_end) line_end = end;
    position = line_end == end ? end : line_end + 1;
    const char* stop = line_end > line_start_ && line_end[-1] == '\r' ? line_end - 1 : line_end;
    const char* begin = line_start_;
    while (begin < stop && is_blank(*begin)) ++begin;
    if (begin == stop || *begin == '#') continue;
    if (names_.empty()) {
      read_header(line_start_, stop, columns);
      const auto lines = std::count(position, end, '\n') + 1;
      values_.reserve(static_cast<std::size_t>(lines) * width_);
      start_.reserve(static_cast<std::size_t>(lines));
      line_.reserve(static_cast<std::size_t>(lines));
    } else {
      read_row(line_start_, stop);
    }
  }
  if (names_.empty()) {
    deck::refuse({file_, 0, 0}, fmt::format("the file is empty; {} begins with the header {}", columns.kind,
                                            fmt::join(columns.required, ",")));
  }
  if (start_.empty()) deck::refuse({file_, 0, 0}, "the file has a header but no rows; add at least one");
}

void CsvTable::read_header(const char* begin, const char* end, const CsvColumns& columns) {
  std::vector<std::string> known = columns.optional;
  known.insert(known.end(), columns.required.begin(), columns.required.end());
  const char* field = begin;
  for (;;) {
    const char* comma = std::find(field, end, ',');
    const char *first = field, *last = comma;
    trim(first, last);
    const std::string name(first, last);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::string near = deck::nearest(name, known);
      const bool other_separator = near.empty() && name.find_first_of("; \t") != std::string::npos;
      refuse_at(first, fmt::format("{} is not a column of {}{}; the columns are {}{}", shown(first, last), columns.kind,
                                   near.empty() ? "" : ", did you mean " + near + "?", fmt::join(known, ", "),
                                   other_separator ? ", separated by commas" : ""));
    }
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) {
      refuse_at(first, fmt::format("the column {} is named twice; keep one", name));
    }
    names_.push_back(name);
    if (comma == end) break;
    field = comma + 1;
  }
  width_ = names_.size();
  for (const std::string& name : columns.required) {
    if (has(name)) continue;
    refuse_at(begin, fmt::format("the column {} is missing; {} has the columns {}", name, columns.kind,
                                 fmt::join(columns.required, ", ")));
  }
}

void CsvTable::read_row(const char* begin, const char* end) {
  start_.push_back(static_cast<std::size_t>(begin - text_.data()));
  line_.push_back(line_number_);
  const char* field = begin;
  for (std::size_t column = 0;; ++column) {
    if (column == width_) {
      const auto values = width_ + 1 + static_cast<std::size_t>(std::count(field, end, ','));
      refuse_at(field, fmt::format("{} values in this row, but the header names {} columns", values, width_));
    }
    const char *comma = std::find(field, end, ','), *first = field, *last = comma;
    trim(first, last);
    double value = 0;
    const auto [stop, code] =
        std::from_chars(first + (last - first > 1 && *first == '+' && first[1] != '-'), last, value);
    if (code == std::errc::result_out_of_range && stop == last) {
      refuse_at(first, fmt::format("{} is too large or too small for a 64-bit number", shown(first, last)));
    }
    if (code != std::errc() || stop != last) {
      refuse_at(first, fmt::format("{} is not a number (column {})", shown(first, last), names_[column]));
    }
    if (!std::isfinite(value)) {
      refuse_at(first, fmt::format("{} is not a finite number (column {})", shown(first, last), names_[column]));
    }
    values_.push_back(value);
    if (comma == end) {
      if (column + 1 == width_) return;
      refuse_at(end, fmt::format("{} value{} in this row, but the header names {} columns", column + 1,
                                 column == 0 ? "" : "s", width_));
    }
    field = comma + 1;
  }
}

deck::Location CsvTable::where(std::size_t row, std::size_t column) const {
  const char* const begin = text_.data() + start_[row];
  const char* field = begin;
  for (std::size_t k = 0; k < column; ++k) field = std::strchr(field, ',') + 1;
  while (is_blank(*field)) ++field;
  return {file_, static_cast<int>(line_[row]), static_cast<int>(field - begin) + 1};
}

}  // namespace perinox::body
