/// Declares the keys of a study file.
#include "perinox/deck/key_forms.hpp"
#include "perinox/study/study.hpp"

namespace perinox::study {

namespace {
using deck::Key;
using deck::list_key;
using deck::map_key;
using deck::required;
using deck::text_key;

/// A key that holds keys of the deck and their values.
Key settings_key(std::string sentence) {
  Key key;
  key.name = "set";
  key.type = deck::Type::named;
  key.sentence = std::move(sentence);
  key.element.push_back(text_key("", "A value as --set takes it."));
  return key;
}

Key declare_sweep() {
  Key point = map_key("", "One value.",
                      {required(text_key("label", "What tables and plots call it; best a number.")),
                       required(settings_key("Keys of the deck and their values at this point."))});
  point.place = "a point";
  Key points = list_key("points", "The values of a sweep that sets several keys at once.", point);
  points.minimum_items = 1;
  Key values = list_key("values", "The values of the key, each as --set takes it.", text_key("", "A value."));
  values.minimum_items = 1;
  values.unique = true;
  Key sweep = map_key(
      "", "One parameter.",
      {text_key("name", "Its name in tables, plots and formulas; by default the key's last word."),
       text_key("key", "Dotted path of a key of the deck, or ranks: the number of MPI ranks."), values, points});
  sweep.place = "a sweep";
  sweep.alternatives = {{"key", "values"}, {"points"}};
  Key list = required(list_key("sweep", "The parameters; every combination of their values is run.", sweep));
  list.minimum_items = 1;
  return list;
}

Key declare_measures() {
  std::vector<Key> components;
  for (const int columns : {3, 9, 1})
    for (const std::string& name : components_of(columns))
      components.push_back(text_key(name, columns == 1   ? "Of a scalar field."
                                          : columns == 3 ? "Of a vector field."
                                                         : "Of a tensor field."));
  Key solution =
      map_key("solution",
              "With field: the exact field, a formula of x, y, z and t for each component; those left out are not "
              "compared.",
              components);
  solution.place = "a solution";
  Key take = deck::word_key(
      "take", take_words(), "end",
      "With history, which row: the end of a run that has come to it; the first or last row there is; the row in which "
      "the "
      "formula is largest or smallest, its value (max, min) or its argument (argmax, argmin). All but end are taken of "
      "runs that stopped short too.");
  Key measure = map_key(
      "", "One measure.",
      {required(text_key("name", "Name of its columns.")),
       text_key("history", "Formula of the columns of history.csv, in the simplest case one column's name."),
       text_key("field", "Field of results.h5; the deck's output.fields must name it."), take,
       text_key("argument",
                "With take: argmax or argmin: formula of the columns that is taken in that row; by default t."),
       text_key("at", "Load parameter t at which it is taken; there must be a step. By default the end of the run."),
       text_key("exact",
                "With history: the exact value, a number or a formula of sweep values; gives relative errors."),
       solution,
       text_key("reference",
                "With field: finest, the run with most particles among those that differ in the first numeric sweep "
                "only; or a file results.h5, relative to the study's folder."),
       text_key(
           "where",
           "With field: condition on x, y, z; only particles where it holds are compared. With history: condition on "
           "the columns; only rows where it holds are looked at.")});
  measure.place = "a measure";
  measure.alternatives = {{"history"}, {"field"}};
  Key list = list_key("measures", "What is taken from each run.", measure);
  list.fallback = "[]";
  return list;
}

Key declare_plots() {
  Key plot = map_key("", "One plot.",
                     {required(text_key("x", "A sweep or a column of study.csv.")),
                      required(text_key("y", "A column of study.csv."))});
  plot.place = "a plot";
  Key list = list_key("plots",
                      "Plots instead of the usual ones, which are: each error against the first numeric sweep, and "
                      "against CPU seconds.",
                      plot);
  list.fallback = "[]";
  return list;
}
}  // namespace

deck::Key declare_study() {
  Key kind = deck::word_key("kind", {"convergence", "newton"}, "convergence",
                            "What is plotted: errors of measures, or the residuals of Newton's iterations.");
  Key step = deck::integer_key("newton_step", 1, 1e9, "",
                               "Step whose Newton iterations are shown; by default the last one of each run.");
  Key repeat = deck::integer_key("repeat", 1, 1000, "1",
                                 "Times that each run is made; costs are those of the one with least CPU seconds.");
  Key set = settings_key("Keys of the deck and their values in every run.");
  set.fallback = "{}";
  Key root = map_key("", "The study.",
                     {text_key("title", "Shown in the report; by default the study file's name."),
                      required(text_key("deck", "The deck, relative to the study's folder.")), kind, set,
                      declare_sweep(), declare_measures(), repeat, step, declare_plots()});
  root.place = "a study";
  root.required = true;
  return root;
}

}  // namespace perinox::study
