#include "perinox/body/exposed_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "curved_faces.hpp"

namespace perinox::body {

namespace {

constexpr int most_layers = 3;
constexpr double share[most_layers + 1][most_layers] = {{}, {1}, {1.5, -0.5}, {13.0 / 12, 4.0 / 12, -5.0 / 12}};

/// Which cell of a lattice a particle lies in, over this rank's particles of all bodies.
class CellsOfLattice {
 public:
  /// The lattice that the particle `on` lies on.
  CellsOfLattice(const Body& body, LocalIndex on, double spacing)
      : origin_(body.position3(on)), spacing_(spacing), dimension_(body.dimension) {
    for (LocalIndex i = 0; i < body.local(); ++i) particle_.emplace(key(cell(body.position3(i))), i);
  }
  /// `steps` cells away from x along an axis; -1: no particle.
  LocalIndex from(deck::Point x, int axis, int steps) const {
    x[static_cast<std::size_t>(axis)] += steps * spacing_;
    const auto found = particle_.find(key(cell(x)));
    return found == particle_.end() ? -1 : found->second;
  }

 private:
  using Cell = std::array<long long, 3>;
  Cell cell(const deck::Point& x) const {
    Cell c{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
      c[k] = std::llround((x[k] - origin_[k]) / spacing_);
    return c;
  }
  /// Different for cells less than 2^20 apart.
  static long long key(const Cell& c) { return (c[0] & mask) << 42 | (c[1] & mask) << 21 | (c[2] & mask); }

  static constexpr long long mask = (1LL << 21) - 1;
  deck::Point origin_;
  double spacing_;
  int dimension_;
  std::unordered_map<long long, LocalIndex> particle_;
};

}  // namespace

std::vector<FaceShare> exposed_faces(const deck::Deck& deck, const Body& body, const std::vector<LocalIndex>& set,
                                     const deck::Location& location) {
  const int d = body.dimension;
  const int sides = 2 * d;
  const auto spacing = [&](LocalIndex i) { return deck.body[static_cast<std::size_t>(body.part[i])].spacing; };
  std::string sentence;
  for (const LocalIndex i : set)
    if (sentence.empty() &&
        std::holds_alternative<deck::CloudFile>(deck.body[static_cast<std::size_t>(body.part[i])].shape.form))
      sentence = fmt::format(
          "{}: the set holds particles of the point cloud {}, whose surface is not known; use force, or give the body "
          "a shape and a spacing",
          location.text(), deck.body[static_cast<std::size_t>(body.part[i])].name);
  body.communicator.agree_on_input_error(sentence);

  std::vector<CellsOfLattice> lattices;
  std::vector<int> lattice_of(deck.body.size(), -1);
  const auto lattice = [&](LocalIndex i) -> const CellsOfLattice& {
    int& number = lattice_of[static_cast<std::size_t>(body.part[i])];
    if (number < 0) {
      number = static_cast<int>(lattices.size());
      lattices.emplace_back(body, i, spacing(i));
    }
    return lattices[static_cast<std::size_t>(number)];
  };
  CurvedFaces curved(deck, body);
  // How many particles share each face, of every particle in the set; decided by its owner, known to all.
  std::vector<double> layers(static_cast<std::size_t>(body.local()) * sides, 0.0);
  double faces = 0;
  for (const LocalIndex i : set)
    for (int face = 0; face < sides; ++face) {
      const int axis = face / 2, side = face % 2 == 0 ? 1 : -1;
      if (lattice(i).from(body.position3(i), axis, side) >= 0 || curved.replaces(i, axis, side)) continue;
      const int in_reach = 1 + static_cast<int>(std::floor(body.reach / spacing(i) + 1e-9));
      int count = 1;
      while (count < std::min(most_layers, in_reach) && lattice(i).from(body.position3(i), axis, -side * count) >= 0)
        ++count;
      layers[static_cast<std::size_t>(i) * sides + face] = count;
      ++faces;
    }
  std::vector<FaceShare> shares = curved.shares(set);
  if (!(body.communicator.sum(faces + static_cast<double>(shares.size())) > 0))
    body.communicator.agree_on_input_error(fmt::format(
        "{}: no particle of the set lies at the surface; take the outermost layer into it", location.text()));
  body.halo.update_ghosts(layers.data(), sides);

  for (LocalIndex i = 0; i < body.local(); ++i)
    for (int face = 0; face < sides; ++face) {
      const auto count = static_cast<int>(layers[static_cast<std::size_t>(i) * sides + face]);
      const int axis = face / 2, side = face % 2 == 0 ? 1 : -1;
      for (int k = 0; k < count; ++k) {
        const LocalIndex behind = k == 0 ? i : lattice(i).from(body.position3(i), axis, -side * k);
        if (behind < 0 || behind >= body.owned) continue;
        deck::Point center = body.position3(i);
        center[static_cast<std::size_t>(axis)] += 0.5 * side * spacing(i);
        const double area = share[count][k] * std::pow(spacing(i), d - 1);
        shares.push_back({behind, axis, side, center, area, area});
      }
    }
  std::sort(shares.begin(), shares.end(), [&](const FaceShare& a, const FaceShare& b) {
    return std::tie(a.particle, a.axis, a.side, a.center) < std::tie(b.particle, b.axis, b.side, b.center);
  });
  return shares;
}

}  // namespace perinox::body
