#include "perinox/fracture/let_go.hpp"

#include <algorithm>

namespace perinox::fracture {

LetGo let_loose_go(mechanics::Scene& scene, loads::Boundary& boundary, BondBreaking& breaking,
                   const mechanics::PlasticExtension& plastic, const PiecesLoads& loads, Observer& observer,
                   MovingState* motion) {
  const LoosePieces found = find_loose(scene, boundary, plastic, loads);
  breaking.count_also(found);
  for (const std::string& sentence : found.sentences) observer.note(sentence);
  LetGo changed;
  changed.bonds = found.broken > 0;
  changed.particles = scene.body().communicator.any(
      std::any_of(found.loose.begin(), found.loose.end(), [](char loose) { return loose != 0; }));
  if (changed.bonds && motion) motion->bonds_have_broken();
  if (!changed.particles) return changed;
  boundary.let_go(found.loose);
  if (motion) motion->supports_have_changed();
  return changed;
}

}  // namespace perinox::fracture
