/// Declares the deck's top level: every part in the order in which the reference page shows it.
#include "declare.hpp"
#include "words.hpp"

namespace perinox::deck {
namespace {

Key declare_horizon() {
  Key ratio = number_key("ratio", "-", "Horizon divided by the largest spacing of the bodies.");
  ratio.minimum = 1;
  Key length = positive_key("length", "length", "Horizon as a length.");
  Key key = required(choice_key("horizon", "Distance up to which two particles interact.", {ratio, length}));
  key.example = "horizon: {ratio: 3.015}";
  return key;
}

Key declare_bonds() {
  Key key = map_key(
      "bonds", "Which bonds are made.",
      {word_key("across_gaps", words::across_gaps, "cut",
                "Bonds more than 0.3 spacings of whose straight line lie outside the bodies' shapes, as across a slit, "
                "a notch or the gap between two bodies: not made (cut), or made like all others (keep). The spacing is "
                "the mean of both ends'; a narrower gap is none, and material on both sides is bonded through it. With "
                "bond_bodies: false the shape is that of the bond's own body. The shape of a point cloud is its "
                "outline; without one its bonds are kept, those to other bodies too.")});
  key.fallback = "{}";
  key.example = "bonds: {across_gaps: keep}";
  return key;
}

Key declare_materials(const std::vector<ModelDeclaration>& models) {
  std::vector<std::string> names;
  for (const ModelDeclaration& model : models) names.push_back(model.name);
  Key element =
      map_key("", "One material; its other keys are those of its model.",
              {required(word_key("model", names, "", "The material model, which decides the other keys.")),
               positive_key("density", "mass/volume", "Mass density; needed only by dynamics."), declare_damage()});
  element.place = "a material";
  element.picks_model = true;
  Key key;
  key.name = "materials";
  key.type = Type::named;
  key.sentence = "The materials, each under a name of your choice that bodies refer to.";
  key.required = true;
  key.element.push_back(element);
  return key;
}

Key declare_steps() {
  Key end = positive_key("end", "-", "Load parameter t at the end of the run; t starts at 0.");
  end.fallback = "1";
  Key key = map_key(
      "steps", "How the load parameter t goes from 0 to its end.",
      {end, integer_key("count", 1, 1e9, "10", "Number of steps of equal size."),
       boolean_key("adaptive", true, "Halve a step that fails to converge and let later steps grow again."),
       integer_key("max_cuts", 0, 60, "8", "How often a step may be halved before the run stops."),
       positive_key(
           "time_limit", "seconds",
           "Wall-clock time of the run, set-up included: it stops with a checkpoint, and exit status 1, before "
           "a step that may not end in time. Without it there is no limit."),
       word_key("control", words::control, "load",
                "load: t is given; arc-length: t is found along the path of equilibria, which may turn back.")});
  key.fallback = "{}";
  key.example = "steps: {end: 1.0, count: 20}";
  return key;
}

Key declare_output(const std::vector<FieldDeclaration>& declared) {
  std::vector<std::string> names;
  for (const FieldDeclaration& field : declared) names.push_back(field.name);
  Key field = word_key("", names, "", "Name of a field.");
  field.names_field = true;
  Key fields = list_key("fields",
                        "The fields written at each output step; perinox help FIELD says what one is, and which scenes "
                        "have it.",
                        field);
  fields.unique = true;
  fields.fallback = "[displacement, force]";
  Key seconds = positive_key("checkpoint_seconds", "seconds",
                             "Write checkpoint.h5, from which perinox run --restart goes on, when the last one is so "
                             "long ago, on the clock, and twenty times as long as it took to write: after a step, and "
                             "while a run moves in time also within one. The end of the run and a stop always have "
                             "one.");
  seconds.fallback = "5";
  Key key = map_key(
      "output", "What is written to results.h5, and how often a checkpoint.",
      {integer_key("every", 1, 1e9, "1", "Write every so many converged steps; the last is always written."), fields,
       integer_key("checkpoint_every", 0, 1e9, "",
                   "Write checkpoint.h5 after every so many converged steps, whatever the clock says; 0: only when the "
                   "run is stopped."),
       seconds});
  key.fallback = "{}";
  key.example = "output: {every: 5, fields: [displacement, force, dilatation]}";
  return key;
}

Key declare_history() {
  Key element =
      map_key("", "One column of history.csv.",
              {required(text_key("name", "Name of the column.")),
               text_key("reaction", "Set whose total reaction force is recorded: a set's or body's name, or all."),
               text_key("displacement",
                        "Set whose mean displacement is recorded, each particle weighted by its volume: a set's or "
                        "body's name, or all."),
               text_key("yielded",
                        "Set whose share of volume that has flowed plastically at any time since the start is "
                        "recorded, whether it flows now or not."),
               word_key("component", words::component, "",
                        "Direction; needed by reaction and displacement, not allowed with yielded.")});
  element.place = "a history entry";
  element.alternatives = {{"reaction"}, {"displacement"}, {"yielded"}};
  Key key = list_key("history", "Numbers recorded after every converged step in history.csv.", element);
  key.fallback = "[]";
  key.example = "history:\n  - {name: pull, reaction: head, component: z}\n  - {name: plastic, yielded: all}";
  return key;
}

}  // namespace

Key declare_deck(const std::vector<ModelDeclaration>& models, const std::vector<FieldDeclaration>& fields) {
  Key title = text_key("title", "Shown in the report and in messages; by default the deck's file name.");
  Key dimension = required(
      word_key("dimension", words::dimension, "", "3 for a solid, or a plane state with two unknowns a particle."));
  dimension.example = "dimension: 3";
  Key influence =
      word_key("influence", words::influence, "constant",
               "Weight of a bond by its length: 1, 1/length, or a polynomial that ends at 0 at the horizon.");
  influence.example = "influence: inverse";
  Key deformation =
      word_key("deformation", words::deformation, "finite",
               "finite: bonds turn and stretch with the body; small: they keep their reference direction, "
               "which leaves out the geometric term and is cheaper, for small strains and rotations only.");
  deformation.example = "deformation: small";
  Key quadrature = word_key("quadrature", words::quadrature, "position-aware",
                            "How much of a neighbour's volume counts near the horizon: all of it, the part inside the "
                            "horizon (linear taper, neighbours just outside included), or that taper without the "
                            "neighbours outside, as LAMMPS has it. position-aware: all of it, with weights and a fit "
                            "of the strain that make uniform strain exact at every point, surfaces included. "
                            "surface-energy: all of it, with the shear stiffness of each point scaled so that its "
                            "energy is right on average over all shears, for comparison.");
  quadrature.example = "quadrature: partial-volume";
  Key bond_bodies = boolean_key("bond_bodies", true, "Particles of different bodies form bonds.");
  bond_bodies.example = "bond_bodies: false";
  Key overlap =
      word_key("overlap", words::overlap, "refuse",
               "Where shapes of two bodies overlap: the deck is refused, or the body that comes later in the "
               "list takes that part from the earlier one. Less than 0.001 of the spacing counts as touching.");
  overlap.example = "overlap: later-wins";
  title.example = "title: block in tension";
  Key root = map_key("", "The deck.",
                     {title,
                      dimension,
                      declare_body(),
                      overlap,
                      bond_bodies,
                      declare_bonds(),
                      declare_horizon(),
                      influence,
                      quadrature,
                      deformation,
                      declare_cracks(),
                      declare_materials(models),
                      declare_sets(),
                      declare_boundary(),
                      declare_dynamics(),
                      declare_initial_velocity(),
                      declare_explicit(),
                      declare_fracture(),
                      declare_fallback(),
                      declare_hand_over(),
                      declare_steps(),
                      declare_arc_length(),
                      declare_solver(),
                      declare_output(fields),
                      declare_history()});
  root.place = "a deck";
  root.required = true;
  return root;
}

}  // namespace perinox::deck
