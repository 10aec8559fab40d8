#include <fmt/format.h>

#include <algorithm>

#include "describe.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::deck {
namespace {

std::vector<std::string> words_of(const std::string& path) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : path + ".") {
    if (c != '.') {
      word += c;
    } else {
      const bool index =
          !word.empty() && std::all_of(word.begin(), word.end(), [](char d) { return d >= '0' && d <= '9'; });
      if (!index) words.push_back(word);
      word.clear();
    }
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ".")); }

bool ends_with(const std::string& path, const std::string& last) {
  return path == last ||
         (path.size() > last.size() && path.compare(path.size() - last.size() - 1, std::string::npos, "." + last) == 0);
}

std::string overview(const Schema& schema) {
  std::string out =
      "The deck's keys. perinox help KEY tells more of one, help FIELD of an output field, help COMMAND of run, check, "
      "verify, study and help.\n";
  for (const Key& key : schema.root().keys)
    out += fmt::format("  {:<17}{} ({})\n", key.name, key.sentence, default_text({"", "", &key}));
  return out;
}

}  // namespace

std::string Schema::help(const std::string& path) const {
  if (path.empty()) return overview(*this);
  const std::vector<DescribedKey> all = every_key(*this);
  std::vector<const DescribedKey*> matches;
  const auto collect = [&](const auto& fits) {
    if (!matches.empty()) return;
    for (const DescribedKey& described : all) {
      if (fits(described)) matches.push_back(&described);
    }
  };
  std::vector<std::string> words = words_of(path);
  const std::string wanted = joined(words);
  collect([&](const DescribedKey& d) { return d.path == wanted; });
  collect([&](const DescribedKey& d) { return d.path_without_model == wanted; });
  if (words.size() > 2) {  // materials.aluminium.bulk_modulus, sets.foot.where: the second word is the user's own name
    const std::vector<DescribedKey>& keys = all;
    const bool named = std::any_of(keys.begin(), keys.end(), [&](const DescribedKey& d) {
      return d.path == words[0] && d.key->type == Type::named;
    });
    std::vector<std::string> shorter = words;
    shorter.erase(shorter.begin() + 1);
    const std::string unnamed = joined(shorter);
    if (named) collect([&](const DescribedKey& d) { return d.path_without_model == unnamed; });
  }
  collect([&](const DescribedKey& d) { return ends_with(d.path, wanted); });
  const FieldDeclaration* asked_field = field(words.empty() ? "" : words.back());
  const bool is_field = asked_field != nullptr && (words.size() == 1 || path == "output.fields." + asked_field->name);
  if (matches.empty() && is_field) return field_text(*asked_field);
  if (matches.empty()) {
    std::vector<std::string> candidates;
    for (const FieldDeclaration& one : fields()) candidates.push_back(one.name);
    for (const DescribedKey& d : all) candidates.push_back(d.key->name);
    for (const DescribedKey& d : all) candidates.push_back(d.path);
    const std::string hint = did_you_mean(path, candidates);
    refuse({}, path + " is neither a key of a deck nor an output field" +
                   (hint.empty() ? "; perinox help lists the keys, perinox --help the commands" : hint));
  }
  std::vector<std::string> also;
  for (const DescribedKey& d : all) {
    if (words.size() == 1 && matches[0]->path == wanted && d.path != wanted && d.key->name == wanted) {
      also.push_back(d.path);
    }
  }
  std::string out;
  for (const DescribedKey* match : matches) out += (out.empty() ? "" : "\n") + help_text(*match, *this);
  if (!also.empty()) out += "\nThere is also " + listing(also, "and") + ".\n";
  if (is_field) out += "\n" + field_text(*asked_field);
  return out;
}

}  // namespace perinox::deck
