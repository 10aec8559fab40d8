#include <fmt/format.h>

#include <filesystem>

#include "perinox/deck/read.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::deck {
namespace {

/// True for values that stay on one line, as a user would write them: scalars, and short lists and maps of scalars.
bool fits_one_line(const Value& value) {
  const auto is_scalar = [](const Value& inner) { return inner.kind() == Value::Kind::scalar; };
  std::size_t letters = 0;
  if (value.kind() == Value::Kind::list) {
    for (const Value& item : value.items()) {
      if (!is_scalar(item)) return false;
      letters += item.text().size() + 2;
    }
  } else if (value.kind() == Value::Kind::map) {
    for (const auto& [key, inner] : value.entries()) {
      if (!fits_one_line(inner)) return false;
      letters += key.size() + 2 + (is_scalar(inner) ? inner.text().size() : 30);
    }
  }
  return letters < 90;
}

namespace fs = std::filesystem;

/// A value as it is written into a file of `folder`; the folder "" keeps absolute paths.
std::string text_in(const Value& value, const std::string& folder) {
  if (!value.is_file() || folder.empty() || fs::path(value.written()).is_absolute()) return value.text();
  return fs::path(value.text()).lexically_relative(fs::absolute(folder).lexically_normal()).string();
}

void write_flow(const Value& value, const std::string& folder, std::string& out) {
  switch (value.kind()) {
    case Value::Kind::none:
      break;
    case Value::Kind::scalar:
      out += quote_if_needed(text_in(value, folder));
      break;
    case Value::Kind::list: {
      const char* between = "[";
      for (const Value& item : value.items()) {
        out += between;
        write_flow(item, folder, out);
        between = ", ";
      }
      out += value.items().empty() ? "[]" : "]";
      break;
    }
    case Value::Kind::map: {
      const char* between = "{";
      for (const auto& [key, inner] : value.entries()) {
        out += between + quote_if_needed(key) + ": ";
        write_flow(inner, folder, out);
        between = ", ";
      }
      out += value.entries().empty() ? "{}" : "}";
      break;
    }
  }
}

/// Writes a value after `key:` or `-`, ending with a line feed.
void write_block(const Value& value, const std::string& folder, std::size_t indent, bool in_list, std::string& out) {
  if (fits_one_line(value) ||
      (value.kind() == Value::Kind::list && value.items().front().kind() == Value::Kind::scalar)) {
    out += ' ';
    write_flow(value, folder, out);
    out += '\n';
    return;
  }
  if (!in_list) out += '\n';
  bool first = true;
  const auto begin_line = [&] {
    out += in_list && first ? " " : std::string(indent, ' ');
    first = false;
  };
  if (value.kind() == Value::Kind::list) {
    for (const Value& item : value.items()) {
      begin_line();
      out += '-';
      write_block(item, folder, indent + 2, true, out);
    }
  } else {
    for (const auto& [key, inner] : value.entries()) {
      begin_line();
      out += quote_if_needed(key) + ":";
      write_block(inner, folder, indent + 2, false, out);
    }
  }
}

void add_files(const Value& value, const std::string& path, std::vector<InputFile>& files) {
  if (value.is_file()) files.push_back({path, value.text()});
  if (value.kind() == Value::Kind::list)
    for (std::size_t k = 0; k < value.items().size(); ++k)
      add_files(value.items()[k], fmt::format("{}[{}]", path, k), files);
  if (value.kind() == Value::Kind::map)
    for (const auto& [key, inner] : value.entries()) add_files(inner, path.empty() ? key : path + "." + key, files);
}

}  // namespace

std::vector<InputFile> input_files(const Deck& deck) {
  std::vector<InputFile> files;
  add_files(deck.resolved, "", files);
  return files;
}

std::string write_resolved(const Deck& deck, const std::string& folder) {
  std::string out("# The deck with every default filled in; running it reproduces the run.\n");
  for (const auto& [key, value] : deck.resolved.entries()) {
    out += quote_if_needed(key) + ":";
    write_block(value, folder, 2, false, out);
  }
  return out;
}

}  // namespace perinox::deck
