#include "perinox/deck/read.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::deck {
namespace {

/// Short values stay on one line, as a user would write them: scalars, and lists and maps of scalars.
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

void write_flow(const Value& value, std::string& out) {
  switch (value.kind()) {
    case Value::Kind::none:
      break;
    case Value::Kind::scalar:
      out += quote_if_needed(value.text());
      break;
    case Value::Kind::list: {
      const char* between = "[";
      for (const Value& item : value.items()) {
        out += between;
        write_flow(item, out);
        between = ", ";
      }
      out += value.items().empty() ? "[]" : "]";
      break;
    }
    case Value::Kind::map: {
      const char* between = "{";
      for (const auto& [key, inner] : value.entries()) {
        out += between + quote_if_needed(key) + ": ";
        write_flow(inner, out);
        between = ", ";
      }
      out += value.entries().empty() ? "{}" : "}";
      break;
    }
  }
}

/// Writes a value after `key:` or `-`, ending with a line feed.
void write_block(const Value& value, std::size_t indent, bool in_list, std::string& out) {
  if (fits_one_line(value) ||
      (value.kind() == Value::Kind::list && value.items().front().kind() == Value::Kind::scalar)) {
    out += ' ';
    write_flow(value, out);
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
      write_block(item, indent + 2, true, out);
    }
  } else {
    for (const auto& [key, inner] : value.entries()) {
      begin_line();
      out += quote_if_needed(key) + ":";
      write_block(inner, indent + 2, false, out);
    }
  }
}

}  // namespace

std::string write_resolved(const Deck& deck) {
  std::string out("# The deck with every default filled in; running it reproduces the run.\n");
  for (const auto& [key, value] : deck.resolved.entries()) {
    out += quote_if_needed(key) + ":";
    write_block(value, 2, false, out);
  }
  return out;
}

}  // namespace perinox::deck
