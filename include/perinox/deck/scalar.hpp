#pragma once
/// Numbers as text and back, without a locale.
#include <optional>
#include <string>
#include <vector>

namespace perinox::deck {

/// The finite number that is the whole of `text`; nothing if it is no number, not finite or beyond double precision.
std::optional<double> parse_number(const std::string& text);
/// The whole number that is the whole of `text`; nothing if it has a point, an exponent or too many digits.
std::optional<long long> parse_integer(const std::string& text);
/// Shortest decimal that reads back to the same double (at most 17 significant digits).
std::string format_number(double value);
/// `text` as a YAML scalar: plain where that is safe, else in double quotes with escapes.
std::string quote_if_needed(const std::string& text);
/// `text` in double quotes with escapes that YAML and JSON share.
std::string quote(const std::string& text);
/// `a, b or c`.
std::string listing(const std::vector<std::string>& words, const std::string& last = "or");
/// `; did you mean <nearest>?` if a candidate is near, else "".
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace perinox::deck
