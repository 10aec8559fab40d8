/// Declares the keys of bodies, cracks, sets and loads.
#include "declare.hpp"
#include "words.hpp"

namespace perinox::deck {
namespace {

Key corner_keys(std::string name, std::string sentence) {
  Key key = map_key(std::move(name), std::move(sentence),
                    {point_key("min", "length", "Corner with the smallest coordinates."),
                     point_key("max", "length", "Corner with the largest coordinates.")});
  return key;
}

Key shape_list(std::string name, std::string sentence, std::size_t minimum) {
  Key part = choice_key("", "One of the shapes.", {});
  part.alternatives.clear();
  part.reference = "shape";
  Key key = list_key(std::move(name), std::move(sentence), part);
  key.minimum_items = minimum;
  return key;
}

Key components(std::string name, const std::string& unit, std::string sentence, const std::string& of) {
  Key key = map_key(std::move(name), std::move(sentence),
                    {expression_key("x", unit, "x component of the " + of + ": a number or a formula of x, y, z, t."),
                     expression_key("y", unit, "y component of the " + of + ": a number or a formula of x, y, z, t."),
                     expression_key("z", unit, "z component of the " + of + "; only in 3-D.")});
  key.alternatives = {{"x", "y", "z"}};
  return key;
}

}  // namespace

Key declare_shape() {
  Key cylinder = map_key("cylinder", "Solid cylinder.",
                         {point_key("start", "length", "Centre of one end face."),
                          point_key("end", "length", "Centre of the other end face."),
                          required(positive_key("radius", "length", "Radius."))});
  Key sphere =
      map_key("sphere", "Ball; in 2-D a disc.",
              {point_key("center", "length", "Centre."), required(positive_key("radius", "length", "Radius."))});
  Key plate = corner_keys("plate_with_hole", "Box with a round hole along z.");
  plate.keys.push_back(point_key("center", "length", "A point on the hole's axis."));
  plate.keys.push_back(required(positive_key("radius", "length", "Radius of the hole.")));
  Key shape = choice_key("shape", "The region filled with particles.",
                         {corner_keys("box", "Box with faces along the axes."), cylinder, sphere, plate,
                          shape_list("union", "All of these shapes together.", 1),
                          shape_list("difference", "The first of these shapes without all the others.", 2),
                          path_key("file",
                                   "Point cloud, a CSV file with the header x,y,z,volume and a row for each particle; "
                                   "a mesh gives one by the centres and volumes of its elements.")});
  shape.place = "a shape";
  return shape;
}

Key declare_body() {
  Key shape = required(choice_key("shape", "The region filled with particles: exactly one of the shapes.", {}));
  shape.reference = "shape";
  Key outline = choice_key("outline",
                           "Of a point cloud: the shape that its particles fill, so that bonds across its slits and "
                           "notches are found (bonds: {across_gaps: cut}). All its points lie in it, or on it.",
                           {});
  outline.reference = "shape";
  Key element = map_key(
      "", "One body.",
      {required(text_key("name", "Name of the body; sets, loads and histories may refer to it.")), shape,
       positive_key("spacing", "length", "Distance of the particles on the lattice; left out only for a point cloud."),
       required(text_key("material", "Name of one of the materials.")),
       word_key(
           "boundary_cells", words::boundary_cells, "auto",
           "Cells of the lattice that the shape's surface cuts: by the part of them that is inside (cut), or whole "
           "if their centre is inside and not at all otherwise (whole); auto is cut with quadrature "
           "position-aware, which alone can do with it, and whole with the others."),
       outline});
  element.place = "a body";
  Key key = required(list_key("body", "The bodies, each filled with particles.", element));
  key.minimum_items = 1;
  key.example =
      "body:\n"
      "  - name: block\n"
      "    shape: {box: {min: [0, 0, 0], max: [10, 10, 30]}}\n"
      "    spacing: 1.0\n"
      "    material: aluminium\n"
      "  - name: ring\n"
      "    shape:\n"
      "      difference:\n"
      "        - cylinder: {start: [20, 0, 0], end: [20, 0, 5], radius: 8}\n"
      "        - cylinder: {start: [20, 0, 0], end: [20, 0, 5], radius: 4}\n"
      "    spacing: 1.0\n"
      "    material: aluminium";
  return key;
}

Key declare_cracks() {
  Key rectangle = map_key("rectangle", "Parallelogram corner + a*edge1 + b*edge2 with a and b from 0 to 1.",
                          {point_key("corner", "length", "One corner."), point_key("edge1", "length", "First edge."),
                           point_key("edge2", "length", "Second edge.")});
  Key disc =
      map_key("disc", "Flat disc.",
              {point_key("center", "length", "Centre."), point_key("normal", "-", "Normal; any length but zero."),
               required(positive_key("radius", "length", "Radius."))});
  Key segment = map_key("segment", "Straight cut; only in 2-D.",
                        {point_key("start", "length", "One end."), point_key("end", "length", "The other end.")});
  Key element = choice_key("", "One crack.", {rectangle, disc, segment});
  element.place = "a crack";
  Key key = list_key("cracks",
                     "Cuts that are there from the start: bonds that cross one, or touch its edge, are never made. A "
                     "crack may not run through the centre of a particle, which would be on neither side of it.",
                     element);
  key.fallback = "[]";
  key.example = "cracks:\n  - disc: {center: [5, 5, 15], normal: [0, 0, 1], radius: 2}";
  return key;
}

Key declare_sets() {
  Key id = integer_key("", 0, 9.0e18, "", "Particle id, from 0.");
  Key ids = list_key("ids", "The particles with these ids.", id);
  ids.minimum_items = 1;
  ids.unique = true;
  Key element = choice_key(
      "", "One set of particles.",
      {expression_key(
           "where", "-",
           "The particles at whose reference position this formula of x, y, z is true. Its comparisons "
           "take a slack: two sides that moving the particle by 1e-9 of the largest spacing, and the rounding "
           "of the coordinates, along each axis could make equal are equal; <=, >= and == then hold, <, > "
           "and != do not."),
       corner_keys("box", "The particles inside a box, faces included, with the same slack."), ids,
       text_key("body", "The particles of the body of this name.")});
  element.place = "a set";
  Key key;
  key.name = "sets";
  key.type = Type::named;
  key.sentence = "Sets of particles under names of your choice. The set `all` and a set for each body exist already.";
  key.element.push_back(element);
  key.fallback = "{}";
  key.example =
      "sets:\n"
      "  foot: {where: \"z < 1.5\"}\n"
      "  head: {where: \"z > 28.5 && x >= 0\"}\n"
      "  corner: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
      "  pins: {ids: [0, 7]}\n"
      "  specimen: {body: block}";
  return key;
}

Key declare_boundary() {
  Key displacement =
      components("displacement", "length", "Prescribed displacement; components not named stay free.", "displacement");
  displacement.keys.push_back(
      path_key("table", "The whole field from a CSV file with the header t,x,y,z,ux,uy,uz (t may be left out)."));
  displacement.alternatives = {{"x", "y", "z"}, {"table"}};
  Key facing =
      point_key("facing", "-",
                "Of a traction or a pressure: a direction of any length; only surface whose true outward normal has a "
                "part along it counts, at an angle below 90 degrees. There a pressure acts on the whole of its area, "
                "and a traction on its area as it is seen from that direction (a ball: pi R^2).");
  facing.required = false;
  Key element =
      map_key("", "One load.",
              {required(text_key("set", "Where the load acts: a set's or body's name, or all.")), displacement,
               components("force", "force", "Force, total over the set.", "force"),
               components("body_force", "force/volume", "Force per volume.", "force per volume"),
               components("traction", "stress",
                          "Force per area of the reference surface, on the exposed surface of the set's particles: "
                          "the part of their body's own surface in and beside their cells. Where another body touches "
                          "it and bodies bond there is none; over a gap, however narrow, and with bond_bodies: false "
                          "there is. Only on lattices.",
                          "traction"),
               expression_key("pressure", "stress",
                              "Pressure into the body, along the normals of the reference surface, on the exposed "
                              "surface of the set's particles as of a traction: a number or a formula of x, y, z, t, "
                              "evaluated at the middle of each piece of surface in a cell; only on lattices."),
               facing,
               components("velocity", "velocity",
                          "Prescribed velocity; only with dynamics: explicit, where t is the time.", "velocity")});
  element.place = "a load";
  element.alternatives = {{"displacement"}, {"force"}, {"body_force"}, {"traction"}, {"pressure"}, {"velocity"}};
  Key key = list_key("boundary", "Prescribed displacements and applied forces.", element);
  key.fallback = "[]";
  key.example =
      "boundary:\n"
      "  - {set: foot, displacement: {x: 0, y: 0, z: 0}}\n"
      "  - {set: head, displacement: {z: \"0.3*t\"}}\n"
      "  - {set: all, body_force: {y: \"-1e-3*min(t, 1)\"}}\n"
      "  - {set: head, traction: {z: \"200*t\"}, facing: [0, 0, 1]}\n"
      "  - {set: bore, pressure: \"50*t\"}";
  return key;
}

}  // namespace perinox::deck
