/// What is said of a piece of the bodies that nothing holds.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "perinox/loads/rigid_modes.hpp"

namespace perinox::loads {

namespace {

std::string at(const deck::Point& x, int dimension) {
  return dimension == 2 ? fmt::format("({:.6g}, {:.6g})", x[0], x[1])
                        : fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

/// The piece's first particle stands at, on every rank.
deck::Point first_position(const body::Body& body, GlobalId first) {
  std::vector<double> place(3, 0.0);
  for (LocalIndex i = 0; i < body.owned; ++i) {
    if (body.id[i] != first) continue;
    const deck::Point x = body.position3(i);
    place.assign(x.begin(), x.end());
  }
  body.communicator.sum(place);
  return {place[0], place[1], place[2]};
}

/// "the body block (36 particles around (1.5, 1.5, 2))", or a piece of one or of several.
std::string name_of(const FreePiece& piece, const deck::Deck& deck, const body::Body& body,
                    const bonds::Components& components) {
  std::vector<double> in_piece(deck.body.size(), 0.0), in_body(deck.body.size(), 0.0);
  for (LocalIndex i = 0; i < body.owned; ++i) {
    in_body[body.part[i]] += 1;
    if (components.of[i] == piece.component) in_piece[body.part[i]] += 1;
  }
  body.communicator.sum(in_piece);
  body.communicator.sum(in_body);
  std::vector<std::string> names;
  bool whole = true;
  for (std::size_t k = 0; k < deck.body.size(); ++k) {
    if (in_piece[k] == 0) continue;
    names.push_back(deck.body[k].name);
    whole = whole && in_piece[k] == in_body[k];
  }
  const std::string bodies = fmt::format("{} {}", names.size() == 1 ? "body" : "bodies", fmt::join(names, ", "));
  const auto k = static_cast<std::size_t>(piece.component);
  std::string first;
  if (!whole)
    first = fmt::format(", the first is particle {} at {}", components.first[k],
                        at(first_position(body, components.first[k]), body.dimension));
  return fmt::format("{}{} ({} particles around {}{})", whole ? "the " : "a piece of the ", bodies,
                     components.particles[k], at(piece.center, body.dimension), first);
}

}  // namespace

void refuse_free_pieces(const deck::Deck& deck, const medium::Model& model, const std::vector<char>& prescribed) {
  const body::Body& body = model.body();
  const bonds::Components components = bonds::connected_components(body, model.bond_graph());
  const std::vector<FreePiece> free = find_free_pieces(body, components, prescribed);
  if (free.empty()) return;
  const FreePiece& piece = free.front();
  std::string sentence;
  if (piece.touched) {
    sentence = fmt::format("the prescribed displacements do not hold {}: it can {}; prescribe displacements against {}",
                           name_of(piece, deck, body, components), fmt::join(piece.motions, ", "),
                           piece.motions.size() == 1 ? "that" : "these");
  } else {
    sentence = fmt::format(
        "nothing holds {}: none of its displacements is prescribed and no bond joins it to the rest; prescribe some, "
        "or bring it nearer to the rest than the horizon {:g}",
        name_of(piece, deck, body, components), model.horizon());
  }
  if (free.size() > 1)
    sentence +=
        fmt::format(" ({} more {} not held either)", free.size() - 1, free.size() == 2 ? "piece is" : "pieces are");
  deck::refuse(deck.resolved.at("boundary").location(), sentence);
}

}  // namespace perinox::loads
