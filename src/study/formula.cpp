#include "formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "perinox/deck/scalar.hpp"

namespace perinox::study {

namespace {
bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// End of the number that begins at `begin`. Its exponent is no name.
std::size_t end_of_number(const std::string& text, std::size_t begin) {
  const auto digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
  };
  std::size_t end = begin;
  while (digit(end) || (end < text.size() && text[end] == '.')) ++end;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    std::size_t power = end + 1;
    if (power < text.size() && (text[power] == '+' || text[power] == '-')) ++power;
    while (digit(power)) end = ++power;
  }
  return end;
}

bool is_function(const std::string& text, std::size_t after) {
  while (after < text.size() && text[after] == ' ') ++after;
  return after < text.size() && text[after] == '(';
}

/// A number as a formula writes it, also if it is not finite.
std::string number_text(double value) {
  if (std::isfinite(value)) return deck::format_number(value);
  return std::isnan(value) ? "0/0" : value > 0 ? "1/0" : "-1/0";
}
}  // namespace

deck::Expression formula(const std::string& text, const Numbers& numbers, const std::vector<std::string>& others,
                         const deck::Location& where) {
  std::vector<std::string> known = others;
  known.emplace_back("pi");
  for (const auto& [name, value] : numbers) known.push_back(name);
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '.') {
      end = end_of_number(text, i);
    } else if (starts_name(text[i])) {
      while (end < text.size() && continues_name(text[end])) ++end;
      const std::string name = text.substr(i, end - i);
      if (const auto value = numbers.find(name); value != numbers.end()) {
        result += "(" + number_text(value->second) + ")";
        i = end;
        continue;
      }
      if (std::find(known.begin(), known.end(), name) == known.end() && !is_function(text, end)) {
        const std::string hint = deck::did_you_mean(name, known);
        deck::refuse(where, fmt::format("{} in the formula '{}' is not known{}", name, text,
                                        hint.empty() ? "; it may use " + deck::listing(known, "and") : hint));
      }
    }
    result += text.substr(i, end - i);
    i = end;
  }
  return deck::Expression(result, where);
}

std::string with_words(const std::string& text, const std::map<std::string, std::string>& words,
                       const deck::Location& where) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t close = text[i] == '{' ? text.find('}', i) : std::string::npos;
    const std::string name = close == std::string::npos ? "" : text.substr(i + 1, close - i - 1);
    const bool is_name = !name.empty() && starts_name(name[0]) && std::all_of(name.begin(), name.end(), continues_name);
    if (!is_name) {
      result += text[i++];
      continue;
    }
    const auto word = words.find(name);
    if (word == words.end()) {
      std::vector<std::string> known;
      for (const auto& entry : words) known.push_back(entry.first);
      const std::string hint = deck::did_you_mean(name, known);
      deck::refuse(where, fmt::format("{{{}}} names no sweep{}", name,
                                      hint.empty() ? "; the sweeps are " + deck::listing(known, "and") : hint));
    }
    result += word->second;
    i = close + 1;
  }
  return result;
}

}  // namespace perinox::study
