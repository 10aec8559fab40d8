/// Tests what a study file says, and the place and sentence of the error in studies with one mistake each.
#include "study/fixture.hpp"

namespace perinox::study {
namespace {

using fixture::base_study;
using fixture::changed;
using ::testing::ElementsAre;

class StudyFile : public ::testing::Test {
 protected:
  StudyFile() { folder_.write("flat.yaml", fixture::flat_deck); }
  Study study_of(const std::string& yaml) const { return read_text(yaml, folder_ / "study.yaml"); }
  /// The message behind the file's name.
  std::string message_of(const std::string& yaml) const {
    const std::string message = fixture::refusal([&] { study_of(yaml); });
    const std::string file = folder_ / "study.yaml";
    return message.rfind(file, 0) == 0 ? message.substr(file.size() + 1) : message;
  }
  fixture::Folder folder_;
};

TEST_F(StudyFile, IsRead) {
  const Study study = study_of(base_study);
  EXPECT_EQ(study.title, "base");
  EXPECT_EQ(study.deck, folder_ / "flat.yaml");
  EXPECT_EQ(study.kind, Kind::convergence);
  ASSERT_EQ(study.set.size(), 1);
  EXPECT_EQ(study.set[0].key, "solver.newton.tolerance");
  EXPECT_EQ(study.set[0].value, "1e-10");
  ASSERT_EQ(study.sweep.size(), 2);
  EXPECT_EQ(study.sweep[0].name, "quadrature");
  EXPECT_FALSE(study.sweep[0].numeric());
  EXPECT_EQ(study.sweep[1].name, "spacing");
  EXPECT_TRUE(study.sweep[1].numeric());
  EXPECT_EQ(study.sweep[1].points[1].number, 0.5);
  EXPECT_EQ(study.sweep[1].points[1].set[0].key, "body.0.spacing");
  ASSERT_EQ(study.measures.size(), 2);
  EXPECT_THAT(study.measures[0].columns(), ElementsAre("F_error", "F"));
  EXPECT_THAT(study.measures[1].columns(), ElementsAre("u_error", "u_largest"));
  EXPECT_EQ(study.measures[1].solution.at("x"), "0.1*x*t");
  EXPECT_EQ(study.measures[1].at, std::nullopt);
}

TEST_F(StudyFile, PointsSetSeveralKeys) {
  const Study study = study_of(changed(base_study, "{key: body.0.spacing, values: [1, 0.5]}",
                                       "{name: spacing, points: [{label: 1, set: {ranks: 2, body.0.spacing: 1}}]}"));
  ASSERT_EQ(study.sweep[1].points.size(), 1);
  EXPECT_EQ(study.sweep[1].points[0].label, "1");
  ASSERT_EQ(study.sweep[1].points[0].set.size(), 2);
  EXPECT_EQ(study.sweep[1].points[0].set[0].key, "ranks");
}

TEST_F(StudyFile, WithoutATitleIsCalledByItsName) {
  EXPECT_EQ(study_of(changed(base_study, "title: base\n", "")).title, "study");
}

struct Mistake {
  const char* from;
  const char* to;
  const char* message;  ///< behind the file's name
};

TEST_F(StudyFile, MalformedIsRefusedWithPlaceAndRemedy) {
  const Mistake mistakes[] = {
      {"measures:", "mesures:", "7:1: mesures is not a key of a study; did you mean measures?"},
      {"values: [whole", "value: [whole", "5:23: value is not a key of a sweep; did you mean values?"},
      {"{key: quadrature, values: [whole, position-aware]}", "{key: quadrature}",
       "5:5: a sweep with a key needs values: what it is set to"},
      {"key: quadrature, values", "name: quadrature, values",
       "5:5: a sweep with values needs a key: the dotted path of what they set, or ranks"},
      {"{key: quadrature, values: [whole, position-aware]}", "{name: a}",
       "5:5: a sweep is empty; it needs key, values or points"},
      {"[whole, position-aware]", "[]", "5:31: values needs at least 1 entry, but has 0"},
      {"[whole, position-aware]", "[whole, whole]", "5:39: whole is named twice in values; remove one"},
      {"[whole, position-aware]", "[[whole]]",
       "5:32: an entry of values must be a text, but a list was found; write whole without brackets or hyphen"},
      {"key: quadrature", "name: spacing, key: quadrature",
       "6:5: there are two columns spacing; give this one another name"},
      {"key: quadrature", "name: x, key: quadrature",
       "5:5: x means something else in formulas; give the sweep another name"},
      {"history: pull, ", "", "8:5: a measure needs exactly one of history or field, but has none"},
      {"history: pull, ", "history: pull, at: 1, where: t > 1, ",
       "8:44: at is one row already; remove at or where from the measure F"},
      {"history: pull, ", "history: pull, at: 1, take: max, ",
       "8:34: at is one row and take: max chooses among all; remove one of them from the measure F"},
      {"history: pull, ", "history: pull, take: max, argument: t, ",
       "8:51: argument goes with take: argmax and argmin only; remove it from the measure F"},
      {"history: pull, ", "history: pull, take: maximum, ", "8:36: take cannot be 'maximum'; did you mean max?"},
      {"field: displacement, ", "field: displacement, take: max, ",
       "9:42: take does not go with field; remove one of them from the measure u"},
      {"solution: {x: \"0.1*x*t\"}", "exact: 3",
       "9:43: exact does not go with field; remove one of them from the measure u"},
      {", solution: {x: \"0.1*x*t\"}", "",
       "9:5: the measure u of a field needs what it is compared with: solution or reference"},
      {"solution: {x: \"0.1*x*t\"}", "solution: {}", "9:46: a solution needs a formula for at least one component"},
      {"history: pull", "at: later, history: pull", "8:19: at must be a number or end, but 'later' was found"},
      {"name: F", "name: u_largest", "9:5: there are two columns u_largest; give this one another name"},
      {"title: base", "kind: newtn", "1:7: kind cannot be 'newtn'; did you mean newton?"},
      {"title: base", "newton_step: 2", "1:14: newton_step goes with kind: newton only; remove it"},
      {"title: base", "plots: [{x: spacin, y: F_error}]",
       "1:9: spacin is no column of the table; did you mean spacing?"},
  };
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(mistake.to);
    std::string message = message_of(changed(base_study, mistake.from, mistake.to));
    EXPECT_EQ(message, mistake.message);
  }
  EXPECT_EQ(message_of(changed(base_study, "flat.yaml", "none.yaml")),
            "2:7: there is no deck " + (folder_ / "none.yaml") + "; its name starts at the study's folder");
  EXPECT_EQ(message_of(changed(base_study, "solution: {x: \"0.1*x*t\"}", "reference: fine.h5")),
            "9:47: there is no file " + (folder_ / "fine.h5") +
                "; reference is finest or a results.h5, relative to the study's folder");
  EXPECT_EQ(message_of(base_study.substr(0, base_study.find("measures"))),
            "1:1: a study of kind convergence needs measures: what is taken from each run");
}

}  // namespace
}  // namespace perinox::study
