#include "scene_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "perinox/body/overlap.hpp"
#include "perinox/linear/coarse_spacing.hpp"
#include "perinox/mechanics/family_loops.hpp"

namespace perinox::app {

namespace {

const char* name_of(deck::Dimension dimension) {
  switch (dimension) {
    case deck::Dimension::three:
      return "3-D";
    case deck::Dimension::plane_strain:
      return "plane strain";
    case deck::Dimension::plane_stress:
      return "plane stress";
  }
  return "";
}

std::string bytes(double value) {
  if (value >= 1e9) return fmt::format("{:.2f} GB", value / 1e9);
  if (value >= 1e6) return fmt::format("{:.1f} MB", value / 1e6);
  return fmt::format("{:.1f} kB", value / 1e3);
}

/// Memory of this machine that is free for programs, bytes. It is 0 where the system does not say.
double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    double kilobytes = 0;
    if (word == "MemAvailable:" && file >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

/// The tangent that is used and why, and what the matrix costs or would cost. The memory is that of rank 0's machine.
std::string tangent_choice(const deck::Solver& solver, double matrix, double unknowns) {
  const double available = available_memory();
  const std::string here = available > 0 ? fmt::format(", {} are available here", bytes(available)) : "";
  const bool asked = solver.tangent != deck::TangentKind::automatic;
  if (!solver.assembled())
    return fmt::format("tangent matrix-free: {}; a matrix would take about {}{}",
                       asked ? "the deck asks for it" : "nothing that the deck asks for needs a matrix", bytes(matrix),
                       here);
  const bool direct = solver.linear.method == deck::LinearMethod::direct;
  std::string text = fmt::format("tangent assembled: {}; about {}",
                                 asked    ? "the deck asks for it"
                                 : direct ? "the direct method needs it"
                                          : "the preconditioner needs it",
                                 bytes(matrix));
  if (direct) text += fmt::format(", its factors on rank 0 up to {}", bytes(8 * unknowns * unknowns));
  text += here;
  if (available > 0 && matrix > available)
    text += "; that is too much, take preconditioner: automatic and method: automatic";
  return text;
}

/// The number of products that the Krylov method takes at once, and why. It is empty if that is one product.
/// Collective.
std::string steps_choice(const deck::Solver& solver, const mechanics::Scene& scene) {
  if (solver.assembled() || solver.linear.preconditioner == deck::Preconditioner::none) return "";
  const int asked = solver.linear.chebyshev_steps, steps = asked > 0 ? asked : linear::chebyshev_steps(scene);
  if (steps == 1) return "";
  if (asked > 0) return fmt::format("  {} products in one linear iteration: the deck asks for it\n", steps);
  return fmt::format("  {} products in one linear iteration: kappa/mu is {:.3g}, nearly incompressible\n", steps,
                     linear::largest_bulk_over_shear(scene));
}

/// Sums over the ranks that the report needs.
struct Totals {
  long long bonds = 0, cut = 0, across_gaps = 0, ghosts = 0, point_history = 0, bond_history = 0;
  long long smallest = 0, largest = 0;
  double volume = 0;
};

Totals totals_of(const mechanics::Scene& scene) {
  const Communicator& ranks = scene.body().communicator;
  Totals t;
  t.bonds = ranks.sum(scene.families().directed);
  t.cut = ranks.sum(scene.families().cut);
  t.across_gaps = ranks.sum(scene.families().across_gaps);
  t.ghosts = ranks.sum(static_cast<long long>(scene.body().ghosts));
  t.point_history = ranks.sum(static_cast<long long>(scene.point_history().back()));
  long long smallest = 1LL << 40;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    smallest = std::min<long long>(smallest, scene.families().size[i]);
    t.volume += scene.body().volume[i];
    if (scene.material(i).history().per_bond > 0) t.bond_history += scene.families().size[i];
  }
  t.volume = ranks.sum(t.volume);
  t.bond_history = ranks.sum(t.bond_history);
  t.smallest = -ranks.max(-smallest);
  t.largest = ranks.max(static_cast<long long>(scene.largest_family()));
  return t;
}

/// Memory over all ranks, bytes.
struct Memory {
  double families = 0, loops = 0, plastic = 0;
};

Memory memory_of(const mechanics::Scene& scene) {
  const auto sum = [&](std::size_t value) { return scene.body().communicator.sum(static_cast<double>(value)); };
  const mechanics::LoopMemory expected = mechanics::FamilyLoops::make(scene)->expected();
  Memory memory;
  const bonds::Families& families = scene.families();
  memory.families =
      sum((scene.lattice() ? scene.lattice()->bytes() : scene.pairs()->bytes()) +
          families.fit.size() * sizeof(families.fit[0]) + families.moments.size() * sizeof(bonds::Moment));
  memory.loops = sum(expected.evaluation + expected.tangent);
  memory.plastic = sum(expected.plastic);
  return memory;
}

/// The line about particles that do not have a whole cell; "" if all have.
std::string parts_of_cells(const body::Body& body) {
  if (body.spacing == 0) return "";
  const double whole = std::pow(body.spacing, body.dimension);
  double least = 1, most = 1;
  long long count = 0;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    const double part = body.volume[i] / whole;
    least = std::min(least, part);
    most = std::max(most, part);
    if (std::abs(part - 1) > 1e-12) ++count;
  }
  count = body.communicator.sum(count);
  if (count == 0) return "";
  return fmt::format("  surfaces cut cells: {} particles stand for {:.2f} to {:.2f} of one\n", count,
                     body.communicator.min(least), body.communicator.max(most));
}

std::string summary_of(const deck::Deck& deck, const mechanics::Scene& scene, const Totals& t,
                       const body::PartitionReport& partition) {
  const body::Body& body = scene.body();
  const Communicator& ranks = body.communicator;
  std::string out = fmt::format("{}\n", deck.title);
  out += fmt::format("  {}: {} particles, {} unknowns, volume {:g}, horizon {:g}\n", name_of(deck.dimension),
                     body.total, body.total * body.dimension, t.volume, scene.families().horizon);
  out += fmt::format("  {} directed bonds, {} to {} a family (mean {:.1f})", t.bonds, t.smallest, t.largest,
                     static_cast<double>(t.bonds) / static_cast<double>(body.total));
  if (t.cut > 0) out += fmt::format(", {} cut by pre-cracks", t.cut);
  if (t.across_gaps > 0) out += fmt::format(", {} not made across gaps", t.across_gaps);
  out += "\n";
  if (const long long deficient = ranks.sum(scene.families().deficient); deficient > 0)
    out += fmt::format(
        "  {} particles have families that cannot tell all strains apart (a layer one particle thick, few bonds): they "
        "keep the plain formulas, which are wrong there\n",
        deficient);
  if (ranks.size() > 1)
    out += fmt::format("  {} ranks: particles {}, ghosts {}, imbalance {:.3f} in bonds, {:.3f} in particles\n",
                       ranks.size(), fmt::join(partition.owned, " "), fmt::join(partition.ghosts, " "),
                       partition.bond_imbalance, partition.particle_imbalance);
  return out;
}

/// Bodies, materials and sets.
std::string parts_of(const deck::Deck& deck, const mechanics::Scene& scene) {
  const body::Body& body = scene.body();
  const auto particles = [&](const std::string& set) {
    return body.communicator.sum(static_cast<long long>(body.sets.at(set).size()));
  };
  std::string out = "bodies\n";
  for (const deck::BodyPart& part : deck.body)
    out += fmt::format("  {}: {} particles of {}\n", part.name, particles(part.name), part.material);
  if (deck.overlap == deck::Overlap::later_wins)
    for (const body::Overlap& overlap : body::find_overlaps(deck))
      out += fmt::format("  {} takes about {:.4g} from {}, which it overlaps\n", deck.body[overlap.later].name,
                         overlap.volume, deck.body[overlap.earlier].name);
  out += "materials\n";
  for (std::size_t m = 0; m < deck.materials.size(); ++m)
    out += fmt::format("  {}: {}\n", deck.materials[m].name, scene.materials()[m]->summary());
  if (!deck.sets.empty()) out += "sets\n";
  for (const deck::Set& set : deck.sets) out += fmt::format("  {}: {} particles\n", set.name, particles(set.name));
  return out;
}

std::string fields_and_terms(const deck::Deck& deck, const mechanics::Scene& scene, const Totals& t) {
  const body::Body& body = scene.body();
  std::string out = "fields and terms\n";
  if (body.dimension == 2) out += "  thickness 1: forces, reactions and energies are per unit thickness\n";
  out += scene.lattice()
             ? fmt::format("  families: a stencil of {} offsets and their reverses, the same for every particle\n",
                           scene.lattice()->offsets().size())
             : "  families: a list of pairs, each kept once\n";
  out += scene.small_strain() ? "  small strain: bonds keep their direction, no geometric term\n"
                              : "  finite deformation: direction and geometric term of every bond, recomputed\n";
  out += t.bond_history > 0
             ? fmt::format(
                   "  plastic extension on {} of {} bonds, only where something has flowed; {} point history values; "
                   "rank-two modulus where it flows, rank-one elsewhere\n",
                   t.bond_history, t.bonds, t.point_history)
             : "  no plastic history: no block needs it; rank-one modulus\n";
  out += t.cut > 0 ? "  pre-cracks: bonds cut at the start\n" : "  no pre-cracks\n";
  const long long fitted = body.communicator.sum(static_cast<long long>(scene.families().moments.size()));
  if (fitted > 0)
    out += fmt::format("  strain fitted at {} of {} particles: bonds with such an end carry {} sums instead of one\n",
                       fitted, body.total, bonds::mandel_size(body.dimension));
  else if (deck.quadrature == deck::Quadrature::position_aware)
    out +=
        "  no strain fitted: every family is a whole one, cannot tell strains apart, or has a material "
        "without a fit\n";
  return out + parts_of_cells(body);
}

/// Memory, the choice of the solver, and what one product costs.
std::string costs(const deck::Deck& deck, const mechanics::Scene& scene, const Totals& t) {
  const Memory memory = memory_of(scene);
  const double d = scene.dimension();
  const auto particles = static_cast<double>(scene.body().total);
  const auto bonds = static_cast<double>(t.bonds);
  const double local = particles + static_cast<double>(t.ghosts);
  // The bytes of points are those of reference, id, volume and the like, and of committed, trial, evaluated and earlier
  // displacement, forces and point values.
  const double points = local * (2 * d + 3) * sizeof(double) + local * 5 * d * sizeof(double) +
                        (particles * 8 + 2 * static_cast<double>(t.point_history)) * sizeof(double);
  // About the memory of Newton's and the Krylov method's vectors and the preconditioner with a V-cycle (93 bytes a
  // particle measured, 290 with the finer cells).
  const std::string steps = steps_choice(deck.solver, scene);
  const double solving = particles *
                         (14 * d + d * d + (linear::finer_cells_pay(scene) ? 40 : 16) + (steps.empty() ? 0 : 3 * d)) *
                         sizeof(double);
  // A row of the matrix is two families wide: a sphere of twice the horizon holds 8 (2-D: 4) families, less its thin
  // rim.
  const double matrix = bonds * (d == 3 ? 6.8 : 3.7) * d * d * 12;
  std::string out = "memory, all ranks\n";
  const auto line = [&](const char* what, double value) {
    out += fmt::format("  {}: {}, {:.0f} bytes a particle\n", what, bytes(value), value / particles);
  };
  line("families", memory.families);
  line("points and state", points);
  line("loops: internal force and tangent product", memory.loops);
  if (t.bond_history > 0) line("plastic extension, once everything flows", memory.plastic);
  const bool in_time = deck.dynamics == deck::Dynamics::explicit_;
  if (!in_time) line("Newton, Krylov and preconditioner, about", solving);
  if (!in_time && deck.solver.assembled())
    line("assembled matrix, its bonds and stored tangent, about", matrix + bonds * 88);
  if (!in_time) out += fmt::format("solver\n  {}\n{}", tangent_choice(deck.solver, matrix, particles * d), steps);
  // Operations are counted in the sweeps, a reciprocal root as twelve: 12 d + 14 a directed bond, 8 more where it
  // flows. From memory a product reads the plastic extension twice and everything else about once.
  const double product = bonds * (12 * d + 14) + 8 * static_cast<double>(t.bond_history);
  const double read = memory.loops / 2 + memory.families + 2 * memory.plastic;
  return out + fmt::format("cost\n  one {} {:.3g} Mflop, at most {} read; {}\n", in_time ? "time step" : "product",
                           product / 1e6, bytes(read),
                           in_time ? fmt::format("{} rows", deck.steps.count)
                                   : fmt::format("{} load steps of a few Newton iterations each", deck.steps.count));
}

}  // namespace

SceneReport describe(const deck::Deck& deck, const mechanics::Scene& scene, const body::PartitionReport& partition) {
  const Totals t = totals_of(scene);
  SceneReport report;
  report.summary = summary_of(deck, scene, t, partition);
  report.details = parts_of(deck, scene);
  report.details += fields_and_terms(deck, scene, t);
  report.details += costs(deck, scene, t);
  return report;
}

}  // namespace perinox::app
