/// Help, reference page and JSON Schema come from the one declaration and must name everything.
#include <yaml-cpp/yaml.h>

#include <functional>
#include <set>

#include "deck/fixture.hpp"

namespace perinox::deck {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Collects every key in the schema that has a name; the elements of lists and named maps have none.
void collect(const Key& key, std::vector<const Key*>& found) {
  if (!key.name.empty()) found.push_back(&key);
  for (const Key& inner : key.keys) collect(inner, found);
  for (const Key& inner : key.element) collect(inner, found);
}

std::vector<const Key*> all_keys() {
  std::vector<const Key*> found;
  collect(fixture::schema().root(), found);
  for (const auto& definition : fixture::schema().definitions()) collect(definition.second, found);
  for (const ModelDeclaration& model : fixture::schema().models()) {
    for (const Key& key : model.keys) collect(key, found);
  }
  return found;
}

std::string refusal(const std::string& path) {
  try {
    fixture::schema().help(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Schema, EveryKeyIsDescribed) {
  const std::vector<const Key*> keys = all_keys();
  ASSERT_GT(keys.size(), 80u);
  for (const Key* key : keys) {
    ASSERT_FALSE(key->sentence.empty()) << key->name;
    EXPECT_EQ(key->sentence.back(), '.') << key->name;
    EXPECT_EQ(key->name.find('-'), std::string::npos) << key->name;
    EXPECT_FALSE(key->required && key->fallback) << key->name;
    for (const std::string& word : key->words) EXPECT_FALSE(word.empty()) << key->name;
    if (key->type == Type::number || key->type == Type::point) {
      EXPECT_FALSE(key->unit.empty()) << key->name;
    }
  }
}

TEST(Schema, AChoiceOfAModelNeedsNoAlternativesSpelledOut) {
  const ModelDeclaration* model = fixture::schema().model("elastic-plastic");
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(fixture::schema().model("elastic-plastik"), nullptr);
  for (const Key& key : model->keys) {
    if (key.name == "yield_stress") {
      EXPECT_EQ(key.alternatives, (std::vector<std::vector<std::string>>{{"tension"}, {"shear"}}));
    }
  }
}

TEST(Help, TellsAKeyByItsPath) {
  EXPECT_EQ(fixture::schema().help("solver.newton.tolerance"),
            "solver.newton.tolerance\n"
            "  Force residual, relative to the reactions, at which a step is converged.\n"
            "  type: number\n"
            "  unit: dimensionless\n"
            "  default: 1e-9\n"
            "  range: greater than 0 and at most 1\n");
}

TEST(Help, TellsEveryKeyWithALastName) {
  const std::string text = fixture::schema().help("tolerance");
  EXPECT_THAT(text, HasSubstr("solver.newton.tolerance\n"));
  EXPECT_THAT(text, HasSubstr("solver.linear.tolerance\n"));
}

TEST(Help, KnowsModelsShapesAndTheUsersOwnNames) {
  const Schema& schema = fixture::schema();
  EXPECT_THAT(schema.help("materials.elastic.bulk_modulus"), HasSubstr("Bulk modulus."));
  EXPECT_THAT(schema.help("materials.elastic.bulk_modulus"), Not(HasSubstr("elastic-plastic")));
  EXPECT_THAT(schema.help("materials.aluminium.bulk_modulus"), HasSubstr("materials.elastic-plastic.bulk_modulus"));
  EXPECT_THAT(schema.help("sets.foot.where"), HasSubstr("sets.where\n"));
  EXPECT_THAT(schema.help("body.0.shape.box.min"), HasSubstr("Corner with the smallest coordinates."));
  EXPECT_THAT(schema.help("boundary"), HasSubstr("body_force"));
  EXPECT_THAT(schema.help("materials"), HasSubstr("with model elastic-plastic also"));
  EXPECT_THAT(schema.help("horizon"), HasSubstr("exactly one of ratio or length"));
}

TEST(Help, EveryKeyCanBeAskedForByName) {
  const Schema& schema = fixture::schema();
  std::set<std::string> whole_parts;  // a name of a whole part of the deck means that part
  for (const Key& key : schema.root().keys) whole_parts.insert(key.name);
  for (const auto& definition : schema.definitions()) whole_parts.insert(definition.first);
  for (const Key* key : all_keys()) {
    const std::string text = schema.help(key->name);
    EXPECT_THAT(text, HasSubstr(key->name + "\n"));
    if (whole_parts.count(key->name) == 0) {
      EXPECT_THAT(text, HasSubstr(key->sentence));
    }
  }
  EXPECT_THAT(schema.help("body"), HasSubstr("There is also sets.body."));
}

TEST(Help, WithoutAPathListsTheTopLevel) {
  const std::string text = fixture::schema().help("");
  for (const Key& key : fixture::schema().root().keys) EXPECT_THAT(text, HasSubstr("  " + key.name + " "));
}

TEST(Help, NamesTheNearestKey) {
  EXPECT_EQ(refusal("spacng"), "spacng is neither a key of a deck nor an output field; did you mean spacing?");
  EXPECT_EQ(refusal("temperature"),
            "temperature is neither a key of a deck nor an output field; perinox help lists the keys, perinox --help "
            "the commands");
  EXPECT_THAT(refusal("solver.newton.tolerence"), HasSubstr("did you mean solver.newton.tolerance?"));
}

TEST(Help, TellsEveryOutputField) {
  const Schema& schema = fixture::schema();
  ASSERT_EQ(schema.fields().size(), 15u);
  const std::string page = schema.reference_page(), list = schema.help("output.fields");
  for (const FieldDeclaration& field : schema.fields()) {
    for (const std::string* text : {&field.sentence, &field.unit, &field.components, &field.exists})
      EXPECT_FALSE(text->empty()) << field.name;
    EXPECT_EQ(field.sentence.back(), '.') << field.name;
    for (const std::string& path : {field.name, "output.fields." + field.name}) {
      const std::string text = schema.help(path);
      EXPECT_THAT(text, HasSubstr(field.name + ", an output field\n  " + field.sentence + "\n  unit: "));
      EXPECT_THAT(text, HasSubstr("\n  values a particle: " + field.components + "\n  exists: " + field.exists + "\n"));
    }
    EXPECT_THAT(page, HasSubstr("| `" + field.name + "` | " + field.sentence + " | "));
    EXPECT_THAT(list, HasSubstr(field.sentence));
  }
  // This is a name of a key too, so both are told.
  EXPECT_THAT(schema.help("displacement"), HasSubstr("boundary.displacement\n"));
  EXPECT_EQ(
      schema.help("stress"),
      "stress, an output field\n"
      "  Stress tensor, from the force state; zz is that out of the plane in plane strain, and 0 in plane stress.\n"
      "  unit: stress\n"
      "  values a particle: 9: xx, xy, xz, yx, yy, yz, zx, zy, zz, along the axes of the undeformed body\n"
      "  exists: in every run whose materials work on sums over the family, as all built-in ones do\n"
      "  asked for with output: {fields: [stress]}\n");
}

TEST(ReferencePage, NamesEveryKeyOnce) {
  const std::string page = fixture::schema().reference_page();
  for (const Key* key : all_keys()) {
    EXPECT_TRUE(page.find("`" + key->name + "`") != std::string::npos ||
                page.find("." + key->name + "`") != std::string::npos)
        << key->name;
  }
  for (const Key& key : fixture::schema().root().keys) EXPECT_THAT(page, HasSubstr("\n## " + key.name + "\n"));
  for (const ModelDeclaration& model : fixture::schema().models())
    EXPECT_THAT(page, HasSubstr("### model: " + model.name));
}

/// The YAML blocks of the page. The first is a whole deck; each other one replaces that deck's part of the same name.
std::vector<std::string> examples(const std::string& page) {
  std::vector<std::string> found;
  for (std::size_t at = page.find("```yaml\n"); at != std::string::npos; at = page.find("```yaml\n", at)) {
    at += 8;
    const std::size_t end = page.find("```", at);
    found.push_back(page.substr(at, end - at));
    at = end;
  }
  return found;
}

TEST(ReferencePage, EveryExampleReads) {
  const std::vector<std::string> found = examples(fixture::schema().reference_page());
  ASSERT_GT(found.size(), 10u);
  EXPECT_EQ(fixture::message_of(found[0]), "");
  for (std::size_t i = 1; i < found.size(); ++i) {
    YAML::Node deck = YAML::Load(found[0]);
    const YAML::Node part = YAML::Load(found[i]);
    for (const auto& entry : part) deck[entry.first.Scalar()] = entry.second;
    if (part["boundary"]) deck["sets"]["bore"] = YAML::Load("{where: \"x < 1\"}");
    if (part["sets"]) deck["boundary"] = YAML::Load("[{set: foot, displacement: {x: 0}}]");
    if (part["initial_velocity"]) deck["dynamics"] = "explicit";
    if (part["dynamics"] || part["initial_velocity"]) deck["materials"]["aluminium"]["density"] = "2.7e-9";
    YAML::Emitter text;
    text << deck;
    EXPECT_EQ(fixture::message_of(text.c_str()), "") << found[i];
  }
}

TEST(JsonSchema, IsWellFormedAndNamesEveryKey) {
  const YAML::Node json = YAML::Load(fixture::schema().json_schema());
  EXPECT_EQ(json["$schema"].Scalar(), "http://json-schema.org/draft-07/schema#");
  std::set<std::string> named;
  const std::function<void(const YAML::Node&)> walk = [&](const YAML::Node& node) {
    if (node.IsMap()) {
      for (const auto& entry : node) {
        if (entry.first.Scalar() == "properties") {
          for (const auto& property : entry.second) named.insert(property.first.Scalar());
        }
        walk(entry.second);
      }
    } else if (node.IsSequence()) {
      for (const auto& item : node) walk(item);
    }
  };
  walk(json);
  for (const Key* key : all_keys()) {
    const bool is_definition = fixture::schema().definitions().count(key->name) > 0;
    EXPECT_TRUE(named.count(key->name) > 0 || is_definition) << key->name;
  }
  EXPECT_EQ(json["properties"]["body"]["items"]["properties"]["shape"]["$ref"].Scalar(), "#/definitions/shape");
  EXPECT_EQ(json["definitions"]["shape"]["properties"]["union"]["items"]["$ref"].Scalar(), "#/definitions/shape");
  const YAML::Node tolerance = json["properties"]["solver"]["properties"]["newton"]["properties"]["tolerance"];
  EXPECT_EQ(tolerance["exclusiveMinimum"].as<double>(), 0.0);
  EXPECT_EQ(tolerance["maximum"].as<double>(), 1.0);
  EXPECT_EQ(tolerance["default"].as<double>(), 1e-9);
  EXPECT_EQ(json["additionalProperties"].as<bool>(), false);
  EXPECT_EQ(json["properties"]["materials"]["additionalProperties"]["oneOf"].size(), 2u);
}

}  // namespace
}  // namespace perinox::deck
