/// For slips of the keyboard in a deck's layout the message names the line of the slip, not the later one where a YAML
/// parser gives up.
#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <sstream>

#include "deck/fixture.hpp"
#include "deck/layout.hpp"

namespace perinox::deck {
namespace {

using fixture::base_deck, fixture::changed, fixture::message_of;

struct Slip {
  const char* name;
  const char* from;
  const char* to;
  const char* message;  ///< the whole message behind the file's name
};
void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.from << " -> " << slip.to; }

const Slip slips[] = {
    // --- indentation
    {"first_key_of_a_map_too_far", "    model:", "     model:",
     "13:6: the indentation does not fit: model begins in column 6, but bulk_modulus in line 14 of the same block in "
     "column 5; let both begin in one column"},
    {"first_key_of_a_map_too_near", "    model:", "   model:",
     "13:4: the indentation does not fit: model begins in column 4, but bulk_modulus in line 14 of the same block in "
     "column 5; let both begin in one column"},
    {"second_key_of_a_map_too_far", "    bulk_modulus:", "     bulk_modulus:",
     "14:6: the indentation does not fit: bulk_modulus begins in column 6, but model in line 13 of the same block in "
     "column 5; let both begin in one column"},
    {"last_key_of_a_map_too_far", "    yield_stress:", "     yield_stress:",
     "16:6: the indentation does not fit: yield_stress begins in column 6, but shear_modulus in line 15 of the same "
     "block in column 5; let both begin in one column"},
    {"second_key_of_an_entry_too_far", "    shape:", "     shape:",
     "5:6: the indentation does not fit: shape begins in column 6, but name in line 4 of the same block in column 5; "
     "let both begin in one column"},
    {"second_key_of_an_entry_too_near", "    shape:", "   shape:",
     "5:4: the indentation does not fit: shape begins in column 4, but name in line 4 of the same block in column 5; "
     "let both begin in one column"},
    {"last_key_of_an_entry_too_near", "    material: steel", "  material: steel",
     "7:3: this line begins in the column of the list's hyphens (line 4) and has none; write the hyphen, or indent the "
     "line as the other keys of its entry"},
    {"set_too_near", "  head: {where", " head: {where",
     "19:2: the indentation does not fit: head begins in column 2, but foot in line 18 of the same block in column 3; "
     "let both begin in one column"},
    {"hyphen_too_far", "  - set: head\n    disp", "   - set: head\n     disp",
     "22:4: the indentation does not fit: the hyphen begins in column 4, but the hyphen in line 21 of the same block "
     "in "
     "column 3; let both begin in one column"},
    {"key_of_the_deck_too_far", "influence: constant", " influence: constant",
     "9:2: the indentation does not fit: influence begins in column 2, but horizon in line 8 of the same block in "
     "column 1; let both begin in one column"},
    {"tab_for_blanks", "    spacing: 1.0", "\tspacing: 1.0", "6:1: a tab cannot indent a line in YAML; use blanks"},
    {"tab_behind_blanks", "    spacing: 1.0", "  \tspacing: 1.0",
     "6:1: a tab cannot indent a line in YAML; use blanks"},
    // --- colons, hyphens, blanks
    {"no_colon", "dimension: 3", "dimension 3", "2:1: a colon is missing behind dimension; write dimension: 3"},
    {"no_blank_behind_the_colon", "dimension: 3", "dimension:3",
     "2:1: a blank is missing behind the colon of dimension; write dimension: 3"},
    {"no_colon_in_the_first_line", "title: base", "title base",
     "1:1: a colon is missing behind title; write title: base"},
    {"no_blank_in_the_first_line", "title: base", "title:base",
     "1:1: a blank is missing behind the colon of title; write title: base"},
    {"equals_for_a_colon", "dimension: 3", "dimension = 3",
     "2:1: a colon belongs between dimension and its value; write dimension: 3"},
    {"no_colon_in_a_map", "    spacing: 1.0", "    spacing 1.0",
     "6:5: a colon is missing behind spacing; write spacing: 1.0"},
    {"no_blank_in_a_map", "  tangent: matrix-free", "  tangent:matrix-free",
     "26:3: a blank is missing behind the colon of tangent; write tangent: matrix-free"},
    {"no_blank_before_a_flow_map", "    yield_stress: {", "    yield_stress:{",
     "16:5: yield_stress:{tension is not a key of a material; a colon and a blank belong between yield_stress and its "
     "value"},
    {"no_blank_in_a_flow_map", "{ratio: 3.015}", "{ratio:3.015}",
     "8:11: ratio:3.015 is not a key of horizon; a colon and a blank belong between ratio and its value: ratio: 3.015"},
    {"no_colon_in_a_flow_map", "{tolerance: 1e-8}", "{tolerance 1e-8}",
     "27:12: tolerance 1e-8 is not a key of solver.newton; a colon and a blank belong between tolerance and its value: "
     "tolerance: 1e-8"},
    {"no_colon_and_too_far", "    shear_modulus: 80e3", "     shear_modulus 80e3",
     "15:6: to YAML this line goes on with the value of bulk_modulus in line 14, because it is indented further and "
     "has "
     "no colon with a blank behind it; write it as KEY: VALUE, indented as the other keys"},
    {"two_colons", "influence: constant", "influence: constant: yes",
     "9:20: a second colon on this line; put each key on a line of its own, or quotes around a text with a colon"},
    {"no_hyphen", "  - {set: foot, displacement: {x: 0, y: 0, z: 0}}\n  - set: head\n    displacement: {z: \"0.3*t\"}",
     "  - {set: foot, displacement: {x: 0, y: 0, z: 0}}\n  {set: head, displacement: {z: 1}}",
     "22:3: a hyphen is missing: the entries of this list, from line 21 on, begin with one"},
    {"no_blank_behind_the_hyphen", "  - name: block", "  -name: block",
     "4:3: a blank is missing behind the hyphen of this list entry; write - and a blank"},
    {"no_hyphen_of_the_first_entry", "  - name: block", "  name: block",
     "4:3: the indentation does not fit: name begins in column 3, but shape in line 5 of the same block in column 5; "
     "let "
     "both begin in one column, or write the hyphen of a list's entry before the first"},
    // --- brackets and quotes
    {"list_not_closed", "min: [0, 0, 0]", "min: [0, 0, 0",
     "5:24: the list opened with [ here is not closed before the } of line 5, column 48; write ] first"},
    {"map_not_closed", "{end: 1.0, count: 20}", "{end: 1.0, count: 20",
     "24:8: the map opened with { here is not closed; write the closing }"},
    {"outer_map_not_closed", "[4, 4, 8]}}", "[4, 4, 8]}",
     "5:12: the map opened with { here is not closed; write the closing }"},
    {"map_not_closed_in_an_entry", "y: 0, z: 0}}", "y: 0, z: 0}",
     "21:5: the map opened with { here is not closed; write the closing }"},
    {"last_map_not_closed", "component: z}", "component: z",
     "30:5: the map opened with { here is not closed; write the closing }"},
    {"map_not_opened", "{end: 1.0, count: 20}", "end: 1.0, count: 20}",
     "24:8: a { is missing here: a } follows that closes none"},
    {"one_bracket_too_many", "count: 20}", "count: 20}}", "24:29: this } closes nothing that is open; take it out"},
    {"no_comma", "{end: 1.0, count: 20}", "{end: 1.0 count: 20}", "24:18: a comma is missing before this"},
    {"no_comma_behind_a_bracket", "min: [0, 0, 0], max", "min: [0, 0, 0] max", "5:34: a comma is missing before this"},
    {"semicolon_for_a_comma", "{end: 1.0, count: 20}", "{end: 1.0; count: 20}",
     "24:19: a comma separates the entries of a map, not a semicolon; write a comma before this"},
    {"map_in_a_map_not_opened", "displacement: {x: 0, y: 0, z: 0}}", "displacement: x: 0}",
     "21:31: a { is missing here: a key begins where the value of another is expected"},
    {"comma_behind_an_entry", "component: z}", "component: z},",
     "30:47: a comma follows the closing bracket, but this list or map is not in brackets; take it out"},
    {"text_behind_a_bracket", "title: base", "title: [draft] base",
     "1:16: text follows the closing bracket; take it out, or put the whole value into quotes"},
    {"block_under_a_value", "solver:\n", "solver: newton\n",
     "26:3: this line is indented as if it belonged to solver in line 25, which has a value already; take that value "
     "away, or let both begin in column 1"},
    {"point_in_parentheses", "[0, 0, 0]", "(0, 0, 0)",
     "5:24: to YAML this value ends at the comma in its parentheses; put a formula in quotes, and the numbers of a "
     "list in "
     "brackets, as [0, 0, 0]"},
    {"formula_with_a_comma_without_quotes", "\"0.3*t\"", "0.3*min(t, 1)",
     "23:23: to YAML this value ends at the comma in its parentheses; put a formula in quotes, and the numbers of a "
     "list "
     "in brackets, as [0, 0, 0]"},
    {"quotes_not_closed", "title: base", "title: \"base",
     "1:8: the text in quotes that begins here is not closed; write the closing \""},
    {"single_quotes_not_closed", "title: base", "title: 'base",
     "1:8: the text in quotes that begins here is not closed; write the closing '"},
    {"quotes_not_closed_in_a_map", "\"z < 1.5\"", "\"z < 1.5",
     "18:17: the text in quotes that begins here is not closed; write the closing \""},
    {"last_quotes_not_closed", "\"0.3*t\"", "\"0.3*t",
     "23:23: the text in quotes that begins here is not closed; write the closing \""},
    {"text_behind_quotes", "title: base", "title: 'it's base'",
     "1:12: text follows the closing quote; put the whole value into the quotes"},
    // --- characters that look like others
    {"no_break_space", "    spacing: 1.0", "\xC2\xA0   spacing: 1.0",
     "6:1: this is a no-break space, which is no blank in YAML; type a blank in its place"},
    {"no_break_space_behind_the_colon", "spacing: 1.0",
     "spacing:\xC2\xA0"
     "1.0",
     "6:13: this is a no-break space, which is no blank in YAML; type a blank in its place"},
    {"typographic_quotes", "\"z < 1.5\"", "\xE2\x80\x9Cz < 1.5\xE2\x80\x9D",
     "18:17: this is a typographic quotation mark; type \" in its place"},
    {"typographic_minus", "spacing: 1.0",
     "spacing: \xE2\x88\x92"
     "1.0",
     "6:14: this is a typographic minus sign; type - in its place"},
    // --- what no layout explains keeps the parser's own place
    {"alias_without_anchor", "influence: constant", "influence: *nothing",
     "9:12: the alias (*name) refers to an anchor (&name) that is not defined before it; put a text that begins "
     "with * in quotes"},
    {"second_document", "influence: constant", "---\ninfluence: constant",
     "9:1: a second YAML document starts here; a deck is one document, so remove the line ---"},
    {"stray_comma", "{end: 1.0, count: 20}", "{end: 1.0,, count: 20}",
     "24:8: a key is missing or is not a word here; check the commas and colons of this map"},
    {"comma_outside_a_list", "title: base", ",title: base",
     "1:1: this does not belong to the lines above; check indentation, commas and brackets"},
};

class LayoutSlip : public ::testing::TestWithParam<Slip> {};

TEST_P(LayoutSlip, IsNamedWhereItIs) {
  const Slip& slip = GetParam();
  EXPECT_EQ(message_of(changed(base_deck, slip.from, slip.to)), std::string("deck.yaml:") + slip.message);
}

/// The slip is also named with the line ends of Windows and with a byte order mark, which moves no column.
TEST_P(LayoutSlip, IsNamedWithOtherLineEndsToo) {
  const Slip& slip = GetParam();
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : changed(base_deck, slip.from, slip.to))
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(message_of(windows), std::string("deck.yaml:") + slip.message);
}

INSTANTIATE_TEST_SUITE_P(Deck, LayoutSlip, ::testing::ValuesIn(slips),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// Columns count characters, as an editor does, and not bytes.
TEST(Layout, ColumnsBehindLettersOfAnyLanguage) {
  const std::string named = changed(base_deck, "name: pull",
                                    "name: Gr\xC3\xB6\xC3\x9F"
                                    "e");
  EXPECT_EQ(message_of(changed(named, "reaction", "reaktion")),
            "deck.yaml:30:19: reaktion is not a key of a history entry; did you mean reaction?");
  EXPECT_EQ(message_of(changed(named, "head, component", "head component")),
            "deck.yaml:30:34: a comma is missing before this");
  EXPECT_EQ(
      message_of("\xEF\xBB\xBF" + changed(base_deck, "title: base", "title: \xC3\xA4: b")),
      "deck.yaml:1:9: a second colon on this line; put each key on a line of its own, or quotes around a text with a "
      "colon");
}

/// Nothing is found in the shipped decks and in a few texts that YAML allows.
TEST(Layout, OfRightTextsIsRight) {
  int decks = 0;
  for (const char* folder : {"inputs", "inputs/hard", "studies"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(PERINOX_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".yaml") continue;
      std::ifstream file(entry.path());
      std::stringstream text;
      text << file.rdbuf();
      const auto found = find_layout_mistake(text.str());
      EXPECT_FALSE(found) << entry.path() << ":" << found->line << ": " << found->sentence;
      ++decks;
    }
  EXPECT_GT(decks, 60);
  for (const char* text : {
           "a:\n- b: 1\n  c: 2\n- d\ne: 3\n",                             // a list in its key's column
           "a: |\n  b c\n   d: e\n\nf: 1\n",                              // a block text
           "a: [1,\n  2, # more\n  {b: c}]\nd: {\n  e: 1,\n  f: 2\n}\n",  // flow over lines
           "a: one\n  more words\nb: 2\n",                                // a text over two lines
           "a: \"one\n  more\"\nb: 'it''s'\nc: don't # or: do\n",         // quotes
           "- - 1\n  - 2\n- - 3\n",                                       // lists in lists
           "a: &x {b: 1}\nc: *x\n",                                       // anchors
           "---\na: 1\n...\n",
       }) {
    const auto found = find_layout_mistake(text);
    EXPECT_FALSE(found) << text << found->line << ":" << found->column << ": " << found->sentence;
  }
}

/// Damages one to three random characters of a deck. Whatever the message is, it has a place in the text, and what is
/// found in the layout is found again in the same text.
TEST(Layout, SurvivesRandomDamage) {
  std::mt19937 random(7);
  const std::string characters = "{}[]:,-\"' \n\t#|&*ab1\xC2\xA0\r";
  int refused = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string text = base_deck;
    for (int k = static_cast<int>(random() % 3); k >= 0; --k) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0)
        text.erase(at, 1 + random() % 3);
      else
        text.insert(at, 1, characters[random() % characters.size()]);
    }
    const std::string message = message_of(text);
    refused += message.empty() ? 0 : 1;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    if (const auto found = find_layout_mistake(text)) {
      const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
      EXPECT_GE(found->line, 1);
      EXPECT_LE(found->line, lines);
      EXPECT_GE(found->column, 1);
      EXPECT_FALSE(found->sentence.empty());
    }
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace perinox::deck
