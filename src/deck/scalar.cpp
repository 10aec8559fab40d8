#include "perinox/deck/scalar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "perinox/deck/read.hpp"

namespace perinox::deck {
namespace {

template <class Number>
std::optional<Number> parse_whole(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') {
    ++begin;
    if (begin != end && (*begin == '-' || *begin == '+')) return std::nullopt;
  }
  Number value{};
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

bool is_plain(const std::string& text) {
  static const std::vector<std::string> special{"null", "true", "false", "yes", "no", "on", "off", "nan", "inf"};
  if (text.empty() || text.size() > 200) return false;
  if (parse_number(text)) return true;
  std::string lower = text;
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (std::find(special.begin(), special.end(), lower) != special.end()) return lower == "true" || lower == "false";
  const auto letter_or_digit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  const auto allowed = [&](char c) { return letter_or_digit(c) || c == '_' || c == '-' || c == '.' || c == '/'; };
  return (letter_or_digit(text[0]) || text[0] == '/') && std::all_of(text.begin(), text.end(), allowed);
}

}  // namespace

std::optional<double> parse_number(const std::string& text) {
  const auto value = parse_whole<double>(text);
  if (value && !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<long long> parse_integer(const std::string& text) { return parse_whole<long long>(text); }

std::string format_number(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  // Readers of YAML 1.1 take 1e-08 for text and 1.0e-08 for a number.
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

std::string quote(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (c == '\t') {
      result += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string quote_if_needed(const std::string& text) { return is_plain(text) ? text : quote(text); }

std::string listing(const std::vector<std::string>& words, const std::string& last) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) result += i + 1 == words.size() ? " " + last + " " : ", ";
    result += words[i];
  }
  return result;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? "" : "; did you mean " + near + "?";
}

}  // namespace perinox::deck
