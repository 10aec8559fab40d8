#include "perinox/deck/restart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "perinox/deck/scalar.hpp"

namespace perinox::deck {

namespace {

/// The one list of what may change on a restart. A key stands for everything below it.
const std::vector<std::string> changeable = {
    "title",  "steps.end", "steps.count", "steps.adaptive",  "steps.max_cuts",    "steps.time_limit",
    "solver", "output",    "history",     "explicit.safety", "explicit.time_step"};

bool same_number(const std::string& a, const std::string& b) {
  const auto x = parse_number(a), y = parse_number(b);
  return x && y && *x == *y;
}

std::string text_of(const Value& value) {
  switch (value.kind()) {
    case Value::Kind::none:
      return "nothing";
    case Value::Kind::scalar:
      return value.text();
    case Value::Kind::list:
      return fmt::format("a list of {}", value.items().size());
    case Value::Kind::map:
      break;
  }
  return "a map";
}

Value entry(const Value& map, const std::string& key) {
  const auto found =
      std::find_if(map.entries().begin(), map.entries().end(), [&](const auto& e) { return e.first == key; });
  return found == map.entries().end() ? Value() : found->second;
}

void compare(const Value& before, const Value& after, const std::string& path, std::vector<ChangedKey>& changes) {
  const auto changed = [&] { changes.push_back({path, text_of(before), text_of(after), may_change(path)}); };
  if (before.kind() != after.kind()) {
    changed();
  } else if (before.kind() == Value::Kind::scalar) {
    // The contents of input files are compared, not their places.
    if (before.is_file() && after.is_file()) return;
    if (before.text() != after.text() && !same_number(before.text(), after.text())) changed();
  } else if (before.kind() == Value::Kind::list) {
    if (before.items().size() != after.items().size()) {
      changed();
      return;
    }
    for (std::size_t k = 0; k < before.items().size(); ++k)
      compare(before.items()[k], after.items()[k], fmt::format("{}[{}]", path, k), changes);
  } else if (before.kind() == Value::Kind::map) {
    const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
    for (const auto& [key, value] : before.entries()) compare(value, entry(after, key), below(key), changes);
    for (const auto& [key, value] : after.entries())
      if (entry(before, key).kind() == Value::Kind::none) compare(Value(), value, below(key), changes);
  }
}

}  // namespace

Checkpoints checkpoints(const Deck& deck) {
  Checkpoints asked;
  const Value& output = deck.resolved.at("output");
  if (output.has("checkpoint_every")) asked.every = static_cast<int>(output.at("checkpoint_every").integer());
  asked.seconds = output.at("checkpoint_seconds").number();
  const Value& steps = deck.resolved.at("steps");
  if (steps.has("time_limit")) asked.time_limit = steps.at("time_limit").number();
  return asked;
}

std::string not_in_checkpoints(const Deck& deck) {
  if (deck.steps.control != Control::load) return "arc-length control";
  return "";
}

std::vector<ChangedKey> changed_keys(const Value& before, const Value& after) {
  std::vector<ChangedKey> changes;
  compare(before, after, "", changes);
  return changes;
}

bool may_change(const std::string& path) {
  return std::any_of(changeable.begin(), changeable.end(), [&](const std::string& key) {
    return path.rfind(key, 0) == 0 && (path.size() == key.size() || path[key.size()] == '.' || path[key.size()] == '[');
  });
}

std::string refuse_changes(const std::vector<ChangedKey>& changes, const Deck& after, const std::string& checkpoint,
                           double t) {
  std::string refused;
  int more = 0;
  for (const ChangedKey& change : changes) {
    if (change.allowed) continue;
    constexpr std::size_t shown = 300;
    if (refused.size() > shown) {
      ++more;
      continue;
    }
    refused +=
        fmt::format("{}{} ({} there, {} now)", refused.empty() ? "" : ", ", change.path, change.before, change.after);
  }
  if (more > 0) refused += fmt::format(" and {} more", more);
  if (!refused.empty()) {
    std::string keys;
    for (const std::string& key : changeable) keys += (keys.empty() ? "" : ", ") + key;
    return fmt::format(
        "{}: the deck is not the one of {}: {} differs; on a restart only {} may change: undo the change, or start "
        "anew "
        "without --restart",
        after.file, checkpoint, refused, keys);
  }
  if (after.steps.end < t)
    return fmt::format(
        "{}: steps.end = {:g} lies before {}, which is at t = {:g}; raise it, or start anew without --restart",
        after.file, after.steps.end, checkpoint, t);
  return "";
}

}  // namespace perinox::deck
