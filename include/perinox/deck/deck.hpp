#pragma once
/// The deck: what the user wrote, read and checked against the schema, with every default filled in. It is plain data.
/// Later rooms read it and never go back to YAML.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "perinox/deck/expression.hpp"
#include "perinox/deck/fracture.hpp"
#include "perinox/deck/location.hpp"
#include "perinox/deck/value.hpp"

namespace perinox::deck {

using Point = std::array<double, 3>;

enum class Dimension { three, plane_strain, plane_stress };
/// Number of unknowns of a particle: 3, or 2 in plane strain and plane stress.
int unknowns(Dimension dimension);

// --- shapes -------------------------------------------------------------------------------------------------------
struct Shape;
struct Box {
  Point min, max;
};
/// A solid cylinder between the centres of its two end faces.
struct Cylinder {
  Point start, end;
  double radius;
};
/// A ball; in 2-D a disc.
struct Sphere {
  Point center;
  double radius;
};
/// A box with a round hole along z through `center`.
struct PlateWithHole {
  Point min, max, center;
  double radius;
};
struct Union {
  std::vector<Shape> parts;
};
/// The first part without all the others.
struct Difference {
  std::vector<Shape> parts;
};
/// A point cloud: a CSV file with the header x,y,z,volume.
struct CloudFile {
  std::string path;
};
struct Shape {
  Location location;
  std::variant<Box, Cylinder, Sphere, PlateWithHole, Union, Difference, CloudFile> form;
};

struct BodyPart {
  Location location;
  std::string name;
  Shape shape;
  /// Lattice spacing, length. It is optional for a cloud (0: not given).
  double spacing = 0;
  std::string material;
  /// True if cells that the shape's surface cuts count with the part of them that is inside. Otherwise they count whole
  /// or not at all.
  bool cut_cells = false;
  /// The region that the particles of a point cloud fill.
  std::optional<Shape> outline{};
  /// The shape before later bodies took their part of it. It is absent if the shape is as it was written.
  std::optional<Shape> as_written{};
  Location spacing_location{};
};

// --- bonds --------------------------------------------------------------------------------------------------------
/// The horizon. Exactly one of ratio and length is given.
struct Horizon {
  Location location;
  std::optional<double> ratio;  ///< horizon over the largest spacing
  std::optional<double> length;
};
/// What becomes of bonds that leave the material between their particles.
enum class AcrossGaps { cut, keep };
/// What becomes of bodies that overlap.
enum class Overlap { refuse, later_wins };
enum class Influence { constant, inverse, polynomial };
enum class Quadrature { whole, partial_volume, taper_inside, position_aware, surface_energy };

/// The parallelogram corner + a*edge1 + b*edge2, 0 <= a, b <= 1.
struct CrackRectangle {
  Point corner, edge1, edge2;
};
struct CrackDisc {
  Point center, normal;
  double radius;
};
/// A straight cut in 2-D.
struct CrackSegment {
  Point start, end;
};
struct Crack {
  Location location;
  std::variant<CrackRectangle, CrackDisc, CrackSegment> form;
};

// --- materials ----------------------------------------------------------------------------------------------------
/// One material. Its own keys are declared by its model (room materials) and handed over as a checked Value.
struct Material {
  Location location;
  std::string name;
  std::string model;
  Value parameters;
  std::optional<double> density{};  ///< mass a volume (2-D: an area, at unit thickness)
  std::optional<Damage> damage{};
};

// --- sets, loads --------------------------------------------------------------------------------------------------
struct SetWhere {
  Expression condition;
};
struct SetBox {
  Point min, max;
};
struct SetIds {
  std::vector<long long> ids;
};
struct SetBody {
  std::string body;
};
struct Set {
  Location location;
  std::string name;
  std::variant<SetWhere, SetBox, SetIds, SetBody> form;
};

enum class LoadKind { displacement, force, body_force, traction, pressure, velocity };
/// One entry of `boundary`. Components that are not named are free (displacement) or zero (forces).
struct Load {
  Location location;
  std::string set;
  LoadKind kind = LoadKind::displacement;
  std::array<std::optional<Expression>, 3> component;  ///< a pressure has the first one only
  std::optional<Point> facing;  ///< traction and pressure: only faces whose outward normal has a part along this
  /// The whole displacement field from a CSV table instead of expressions; for displacements only.
  std::optional<std::string> table;
  Location table_location;
};

// --- solution -----------------------------------------------------------------------------------------------------
struct Steps {
  double end = 1;        ///< load parameter t at the end; t starts at 0
  int count = 10;        ///< steps of equal size
  bool adaptive = true;  ///< halve a failed step, and let steps grow again
  int max_cuts = 8;      ///< the smallest step is (end/count)/2^max_cuts
  Control control = Control::load;
};
enum class TangentKind { automatic, matrix_free, assembled };
enum class TangentForm { consistent, printed };
enum class LineSearch { backtrack, full_step };
enum class Forcing { eisenstat_walker, constant };
enum class LinearMethod { automatic, cg, gmres, direct };
enum class Preconditioner { automatic, none, two_level, block_jacobi, jacobi, symmetric_gauss_seidel, chebyshev, ilu };
struct Newton {
  double tolerance = 1e-9;  ///< bound on the force residual relative to the reactions
  double update_tolerance =
      1e-6;  ///< of what another update would change, relative to the step's displacement increment
  int max_iterations = 25;
  LineSearch line_search = LineSearch::backtrack;
  Forcing forcing = Forcing::eisenstat_walker;
};
struct Linear {
  LinearMethod method = LinearMethod::automatic;
  Preconditioner preconditioner = Preconditioner::automatic;
  double tolerance = 1e-2;  ///< with constant forcing the tolerance, with Eisenstat-Walker the loosest one
  int max_iterations = 2000;
  int chebyshev_steps = 0;  ///< odd; 0: the scene chooses
};
struct Solver {
  Location location;
  TangentKind tangent = TangentKind::automatic;  ///< as asked for; assembled() tells what is done
  TangentForm form = TangentForm::consistent;
  Newton newton;
  Linear linear;

  /// True if the preconditioner or the direct method works on a matrix.
  bool needs_matrix() const;
  /// True if the assembled tangent is used. With `automatic` the matrix is used only where it is needed, because the
  /// matrix-free product is several times faster and smaller at every size (docs/performance.md).
  bool assembled() const;
};

enum class HistoryKind { reaction, displacement, yielded };
struct HistoryEntry {
  Location location;
  std::string name;
  HistoryKind kind = HistoryKind::reaction;
  std::string set;
  int component = 0;  ///< 0 x, 1 y, 2 z; `yielded` does not use it
};
struct Output {
  int every = 1;
  std::vector<std::string> fields;
};

struct Deck {
  std::string file;
  std::string title;
  Dimension dimension = Dimension::three;
  std::vector<BodyPart> body;
  Overlap overlap = Overlap::refuse;
  bool bond_bodies = true;  ///< particles of different bodies form bonds
  AcrossGaps across_gaps = AcrossGaps::cut;
  Horizon horizon;
  Influence influence = Influence::constant;
  Quadrature quadrature = Quadrature::position_aware;
  bool small_strain = false;  ///< deformation: small
  std::vector<Crack> cracks;
  std::vector<Material> materials;
  std::vector<Set> sets;
  std::vector<Load> boundary;
  Dynamics dynamics = Dynamics::quasi_static;
  std::vector<InitialVelocity> initial_velocity;
  Explicit motion;  ///< the key `explicit`
  Fracture fracture;
  Fallback fallback = Fallback::automatic;
  HandOver hand_over;
  Steps steps;
  ArcLength arc_length;
  Solver solver;
  Output output;
  std::vector<HistoryEntry> history;

  /// True if bonds of some material can break.
  bool breaks() const;
  /// True if the run is explicit or may come to be.
  bool may_move() const;
  /// True if a run has faces, of cracks or of bodies that are not bonded, with nothing to keep them apart. This is so
  /// in every run with such faces but an explicit one with contact.
  bool may_overlap() const;

  /// The checked deck with all defaults, from which deck.resolved.yaml is written.
  Value resolved;
};

}  // namespace perinox::deck
