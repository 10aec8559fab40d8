#pragma once
/// Converts numbers to text and back, without a locale.
#include <optional>
#include <string>
#include <vector>

namespace perinox::deck {

/// The finite number that `text` as a whole stands for. It is absent if the text is no number, not finite or beyond
/// double precision.
std::optional<double> parse_number(const std::string& text);
/// The whole number that `text` as a whole stands for. It is absent if the text has a point, an exponent or too many
/// digits.
std::optional<long long> parse_integer(const std::string& text);
/// The shortest decimal that reads back to the same double (at most 17 significant digits).
std::string format_number(double value);
/// `text` as a YAML scalar. It is plain where that is safe, otherwise in double quotes with escapes.
std::string quote_if_needed(const std::string& text);
/// `text` in double quotes, with escapes that YAML and JSON share.
std::string quote(const std::string& text);
/// The words as a list in a sentence: `a, b or c`.
std::string listing(const std::vector<std::string>& words, const std::string& last = "or");
/// The text `; did you mean <nearest>?` if a candidate is near, otherwise "".
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace perinox::deck
