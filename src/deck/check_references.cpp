#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "convert.hpp"
#include "history_columns.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::deck {
namespace {

/// Refuses names with odd characters. Names appear in file headers and option paths, so they may have only letters (of
/// any language), digits, blanks and _ - . +.
void refuse_odd_name(const std::string& name, const Location& where, const std::string& of) {
  const auto fits = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') ||
           (byte >= 'A' && byte <= 'Z') || c == '_' || c == '-' || c == '.' || c == '+' || c == ' ';
  };
  if (name.size() <= 100 && std::all_of(name.begin(), name.end(), fits)) return;
  refuse(where,
         fmt::format("'{}' cannot be the name of {}; use at most 100 letters, digits, blanks and _ - . +", name, of));
}

/// Refuses the second of two equal names in a list of maps.
void refuse_repeated_names(const Value& list, const std::string& of) {
  std::map<std::string, int> lines;
  for (const Value& item : list.items()) {
    const Value& name = item.at("name");
    refuse_odd_name(name.text(), name.location(), of);
    const auto [first, fresh] = lines.emplace(name.text(), name.location().line);
    if (!fresh) {
      refuse(name.location(),
             fmt::format("{} is already the name of {} (line {}); choose another", name.text(), of, first->second));
    }
  }
}

void refuse_unknown_name(const Value& value, const std::vector<std::string>& known, const std::string& of,
                         const std::string& remedy) {
  if (std::find(known.begin(), known.end(), value.text()) != known.end()) return;
  std::string hint = did_you_mean(value.text(), known);
  if (hint.empty()) hint = known.empty() ? "; " + remedy : fmt::format("; there is {}", listing(known, "and"));
  refuse(value.location(), fmt::format("{} is not the name of {}{}", value.text(), of, hint));
}

/// Refuses names with which history.csv would have two columns of one name.
void refuse_names_of_columns(const Value& history) {
  for (const Value& entry : history.items()) {
    const Value& name = entry.at("name");
    if (std::find(history_columns.begin(), history_columns.end(), name.text()) != history_columns.end())
      refuse(name.location(), fmt::format("history.csv has a column {} of its own; give this entry another name, such "
                                          "as {}_of_set",
                                          name.text(), name.text()));
  }
}

}  // namespace

void check_references(const Deck& deck) {
  const Value& all = deck.resolved;
  refuse_repeated_names(all.at("body"), "a body");
  refuse_repeated_names(all.at("history"), "a history entry");
  refuse_names_of_columns(all.at("history"));

  std::vector<std::string> bodies, materials, regions{"all"};
  for (const BodyPart& part : deck.body) bodies.push_back(part.name);
  for (const Material& material : deck.materials) materials.push_back(material.name);
  for (const Material& material : deck.materials) refuse_odd_name(material.name, material.location, "a material");
  for (const Value& part : all.at("body").items()) {
    if (part.at("name").text() == "all") {
      refuse(part.at("name").location(), "a body cannot be named all, which means every particle; choose another name");
    }
    refuse_unknown_name(part.at("material"), materials, "a material", "declare it under materials");
  }
  for (const Set& set : deck.sets) {
    refuse_odd_name(set.name, set.location, "a set");
    if (set.name == "all") {
      refuse(set.location, "the set all exists already and means every particle; choose another name");
    }
    if (std::find(bodies.begin(), bodies.end(), set.name) != bodies.end()) {
      refuse(set.location,
             fmt::format("the set {} has the name of a body, for which a set exists already; choose another "
                         "name",
                         set.name));
    }
    if (std::holds_alternative<SetBody>(set.form)) {
      refuse_unknown_name(all.at("sets").at(set.name).at("body"), bodies, "a body", "");
    }
    regions.push_back(set.name);
  }
  regions.insert(regions.end(), bodies.begin(), bodies.end());
  const std::string remedy = "declare it under sets";
  for (const Value& load : all.at("boundary").items()) {
    refuse_unknown_name(load.at("set"), regions, "a set or body", remedy);
  }
  for (const Value& initial : all.at("initial_velocity").items())
    refuse_unknown_name(initial.at("set"), regions, "a set or body", remedy);
  for (const Value& set : all.at("fracture").at("unbreakable").items())
    refuse_unknown_name(set, regions, "a set or body", remedy);
  if (all.at("arc_length").has("until"))
    refuse_unknown_name(all.at("arc_length").at("until").at("set"), regions, "a set or body", remedy);
  for (const Value& entry : all.at("history").items()) {
    for (const char* kind : {"reaction", "displacement", "yielded"}) {
      if (entry.has(kind)) refuse_unknown_name(entry.at(kind), regions, "a set or body", remedy);
    }
  }
}

}  // namespace perinox::deck
