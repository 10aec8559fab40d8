/// Generates docs/deck.md: every key of the schema with type, unit, default, range and sentence.
#include <fmt/format.h>

#include "check.hpp"
#include "describe.hpp"
#include "document.hpp"
#include "perinox/deck/declared.hpp"

namespace perinox::deck {
namespace {

const char* const introduction =
    "# The deck\n"
    "\n"
    "A deck is one YAML file that says what is computed. This page is generated from the same declarations that check "
    "a\n"
    "deck when it is read; `perinox help KEY` shows the same text for one key.\n"
    "\n"
    "- Keys are written with underscores, words with hyphens. No key is ever ignored: an unknown one is an error that "
    "names\n"
    "  the line and the nearest key.\n"
    "- Units are any consistent set (mm, N, MPa, or m, N, Pa); the tables name what kind of quantity a number is.\n"
    "- 2-D bodies have thickness 1: forces, reactions and energies are per unit thickness. Divide a given force by "
    "the\n"
    "  thickness of the part, and multiply a reaction by it.\n"
    "- In the column `default`, `alternative` marks keys that exclude each other.\n"
    "- File names are relative to the deck's folder.\n"
    "- Points have three numbers. In 2-D they may have two; a third must be 0.\n"
    "- `--set key.path=value` on the command line replaces a value: `--set solver.newton.tolerance=1e-9`,\n"
    "  `--set body.0.spacing=0.25` (list entries count from 0), `--set 'horizon={length: 1.5}'`.\n"
    "\n"
    "A formula may use the reference position x, y, z, in loads also the load parameter t, the constant pi, the "
    "operators\n"
    "`+ - * / ^ < <= > >= == != && ||`, the ternary `condition ? a : b`, and the functions sin, cos, tan, asin, acos, "
    "atan,\n"
    "atan2, sinh, cosh, tanh, asinh, acosh, atanh, exp, ln, log (natural, as ln), log2, log10, sqrt, abs, sign, rint, "
    "min,\n"
    "max, sum and avg. Put a formula in quotes.\n";

const char* const example_deck =
    "title: block in tension\n"
    "dimension: 3\n"
    "body:\n"
    "  - name: block\n"
    "    shape: {box: {min: [0, 0, 0], max: [10, 10, 30]}}\n"
    "    spacing: 1.0\n"
    "    material: aluminium\n"
    "horizon: {ratio: 3.015}\n"
    "materials:\n"
    "  aluminium:\n"
    "    model: elastic\n"
    "    bulk_modulus: 67.5e3\n"
    "    shear_modulus: 25.9e3\n"
    "sets:\n"
    "  foot: {where: \"z < 3\"}\n"
    "  head: {where: \"z > 27\"}\n"
    "boundary:\n"
    "  - {set: foot, displacement: {x: 0, y: 0, z: 0}}\n"
    "  - {set: head, displacement: {z: \"0.3*t\"}}\n"
    "steps: {end: 1.0, count: 10}\n"
    "output: {every: 1, fields: [displacement, force, dilatation]}\n"
    "history:\n"
    "  - {name: pull, reaction: head, component: z}\n";

std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string code(const std::string& text) { return "`" + text + "`"; }

const char* const table_head = "| key | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n";

std::string row(const DescribedKey& described, const Schema& schema) {
  const Key& key = *described.key;
  const std::string fallback = default_text(described);
  const bool is_value = key.fallback && fallback != "optional";
  const std::string type =
      key.reference.empty() ? type_text(key, schema) : "[" + key.reference + "](#" + key.reference + ")";
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", code(cell(described.path)), cell(type),
                     cell(unit_text(key.unit)), is_value ? code(cell(fallback)) : fallback, cell(range_text(key)),
                     cell(key.sentence));
}

std::string table(const std::vector<DescribedKey>& keys, const Schema& schema) {
  if (keys.empty()) return "";
  std::string out = table_head;
  for (const DescribedKey& described : keys) out += row(described, schema);
  return out + "\n";
}

std::string section(const Key& key, const Schema& schema) {
  std::string out = fmt::format("## {}\n\n{}\n\n", key.name, key.sentence);
  out += table_head + row({key.name, key.name, &key}, schema) + "\n";
  if (!key.example.empty()) out += "```yaml\n" + key.example + "\n```\n\n";
  const std::vector<DescribedKey> inner = keys_inside(key);
  if (!inner.empty()) out += fmt::format("Inside `{}`:\n\n", key.name) + table(inner, schema);
  return out;
}

std::string model_sections(const Schema& schema) {
  std::string out;
  for (const ModelDeclaration& model : schema.models()) {
    out += fmt::format("### model: {}\n\n{}\n\n", model.name, model.sentence);
    Key all;
    all.keys = model.keys;
    out += table(keys_inside(all), schema);
  }
  return out;
}

std::string field_section(const Schema& schema) {
  std::string out =
      "### Output fields\n\nWhat `output.fields` may name, for each particle in results.h5 "
      "([results.md](results.md)); `perinox help FIELD` shows the same.\n\n"
      "| field | meaning | unit | values a particle | exists |\n|---|---|---|---|---|\n";
  for (const FieldDeclaration& field : schema.fields())
    out += fmt::format("| {} | {} | {} | {} | {} |\n", code(field.name), cell(field.sentence),
                       cell(unit_text(field.unit)), cell(field.components), cell(field.exists));
  return out + "\n";
}

}  // namespace

std::string key_table(const Key& root) {
  static const Schema without_models({});
  return table(keys_inside(root), without_models);
}

std::string Schema::reference_page() const {
  std::string out = introduction;
  out += "\n## A whole deck\n\n```yaml\n" + std::string(example_deck) + "```\n\n";
  for (const Key& key : root_.keys) {
    out += section(key, *this);
    if (key.name == "materials") out += model_sections(*this);
    if (key.name == "output") out += field_section(*this);
    if (key.name != "body") continue;
    for (const auto& [name, definition] : definitions_) {
      out += fmt::format("### {}\n\n{} A map with exactly one of these keys:\n\n", name, definition.sentence);
      out += table(keys_inside(definition), *this);
    }
  }
  while (out.size() > 1 && out[out.size() - 2] == '\n') out.pop_back();
  return out;
}

}  // namespace perinox::deck
