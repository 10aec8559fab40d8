#include "perinox/mechanics/scene.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "perinox/mechanics/plastic_extension.hpp"

namespace perinox::mechanics {

namespace {

std::vector<LocalIndex> all_owned(const body::Body& body) {
  std::vector<LocalIndex> order(static_cast<std::size_t>(body.owned));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Adds what the layouts leave out, in the order of ids.
void add_family(bonds::Bonds& bonds, std::vector<bonds::FoundBond>& family, const body::Body& body) {
  std::sort(family.begin(), family.end(), [&](const bonds::FoundBond& a, const bonds::FoundBond& b) {
    return body.id[a.neighbor] < body.id[b.neighbor];
  });
  for (const bonds::FoundBond& bond : family) {
    bonds.neighbor.push_back(bond.neighbor);
    bonds.length.push_back(bond.length);
    bonds.weight.push_back(bond.weight);
    bonds.influence.push_back(bond.influence);
  }
  bonds.offset.push_back(static_cast<std::int64_t>(bonds.neighbor.size()));
}

}  // namespace

Scene::Scene(body::Body body, const bonds::Bonds& bonds, std::vector<std::unique_ptr<materials::Material>> materials,
             Layout layout, bool small_strain)
    : Model(std::move(body)), families_(bonds), materials_(std::move(materials)), small_strain_(small_strain) {
  auto grid = layout == Layout::automatic ? bonds::find_grid(body_) : std::nullopt;
  if (grid) {
    lattice_ = std::make_unique<bonds::LatticeFamilies>(body_, std::move(*grid));
    for (LocalIndex i = 0; i < body_.owned; ++i) lattice_->receive(i, bonds.family(i), body_);
    lattice_->complete();
  } else {
    const std::vector<LocalIndex> order = bonds::curve_order(body_);
    pairs_ = std::make_unique<bonds::PairFamilies>(body_, order);
    for (const LocalIndex i : order) pairs_->receive(i, bonds.family(i), body_);
    pairs_->complete();
  }
  complete();
}

Scene::Scene(const deck::Deck& deck, body::Body body, double horizon,
             std::vector<std::unique_ptr<materials::Material>> materials, Layout layout)
    : Model(std::move(body)), materials_(std::move(materials)), small_strain_(deck.small_strain) {
  auto grid = layout == Layout::automatic ? bonds::find_grid(body_) : std::nullopt;
  if (grid) {
    lattice_ = std::make_unique<bonds::LatticeFamilies>(body_, std::move(*grid));
    families_ = bonds::find_families(
        deck, body_, horizon, &lattice_->grid(), all_owned(body_),
        [&](LocalIndex i, const std::vector<bonds::FoundBond>& family) { lattice_->receive(i, family, body_); });
    lattice_->complete();
  } else {
    const std::vector<LocalIndex> order = bonds::curve_order(body_);
    pairs_ = std::make_unique<bonds::PairFamilies>(body_, order);
    families_ = bonds::find_families(
        deck, body_, horizon, nullptr, order,
        [&](LocalIndex i, const std::vector<bonds::FoundBond>& family) { pairs_->receive(i, family, body_); });
    pairs_->complete();
  }
  complete();
}

Scene::Scene(Scene&&) noexcept = default;
Scene::~Scene() = default;

void Scene::complete() {
  std::vector<std::int64_t> needs;
  std::vector<int> per_bond;
  for (const auto& material : materials_) {
    from_sums_ = from_sums_ && material->from_sums();
    const materials::HistoryLayout layout = material->history();
    needs.push_back(static_cast<std::int64_t>(layout.point.size()));
    per_bond.push_back(layout.per_bond);
  }
  point_history_.assign(1, 0);
  if (!from_sums_) bond_history_.assign(1, 0);
  for (LocalIndex i = 0; i < body_.owned; ++i) {
    point_history_.push_back(point_history_.back() + needs[body_.material[i]]);
    const int values = per_bond[body_.material[i]];
    plastic_here_ = plastic_here_ || (from_sums_ && values > 0);
    if (!from_sums_) bond_history_.push_back(bond_history_.back() + values * families_.size[i]);
    largest_family_ = std::max(largest_family_, families_.size[i]);
  }
  plastic_ = body_.communicator.any(plastic_here_);
  drop_fits();
}

void Scene::drop_fits() {
  if (families_.fit.empty()) return;
  std::vector<bonds::Moment> kept;
  for (LocalIndex i = 0; i < body_.owned; ++i) {
    if (families_.fit[i] < 0) continue;
    if (!material(i).takes_fit()) {
      families_.fit[i] = -1;
      continue;
    }
    kept.push_back(families_.moments[static_cast<std::size_t>(families_.fit[i])]);
    families_.fit[i] = static_cast<std::int32_t>(kept.size()) - 1;
  }
  families_.moments = std::move(kept);
  if (families_.moments.empty()) families_.fit = {};
}

/// The plastic extension of a bond that breaks stays in its family's sums.
void Scene::keep_extension(LocalIndex i, LocalIndex j, double weight, double length, double plastic) {
  if (material(i).history().per_bond == 0) return;
  families_.broken_extension.resize(static_cast<std::size_t>(body_.owned));
  double direction[3] = {};
  for (int c = 0; c < dimension(); ++c) direction[c] = (body_.position(j)[c] - body_.position(i)[c]) / length;
  const bonds::Mandel basis = bonds::mandel(dimension(), direction, length);
  bonds::BrokenExtension& kept = families_.broken_extension[static_cast<std::size_t>(i)];
  for (std::size_t k = 0; k < basis.size(); ++k) {
    kept.fit[k] += weight * basis[k] * plastic;
    kept.second[k] += weight * length * basis[k];
  }
  kept.square += weight * plastic * plastic;
}

void Scene::set_broken_extension(std::vector<bonds::BrokenExtension> extension) {
  families_.broken_extension = std::move(extension);
  ++bonds_version_;
}

void Scene::break_bonds(const std::vector<BondEnds>& found, const PlasticExtension* plastic) {
  ++bonds_version_;  // also where none of them is this rank's: all ranks evaluate anew or none
  if (found.empty()) return;
  if (!from_sums_) throw std::logic_error("bonds of a material that is not made of sums cannot break");
  // In the order of ids, so that damage adds up alike whoever has found them.
  std::vector<BondEnds> ends = found;
  const auto ids_of = [&](const BondEnds& bond) {
    const GlobalId a = body_.id[bond[0]], b = body_.id[bond[1]];
    return std::make_pair(std::min(a, b), std::max(a, b));
  };
  std::sort(ends.begin(), ends.end(), [&](const BondEnds& a, const BondEnds& b) { return ids_of(a) < ids_of(b); });
  families_.broken_volume.resize(static_cast<std::size_t>(body_.owned), 0.0);
  for (const BondEnds& bond : ends) {
    double extension[2] = {};
    for (const int end : {0, 1})
      if (plastic && bond[static_cast<std::size_t>(end)] < body_.owned)
        extension[end] =
            plastic->of_bond(*this, bond[static_cast<std::size_t>(end)], bond[static_cast<std::size_t>(1 - end)]);
    double square = 0, length = 0;  // omega xi^2 and the quadrature's share
    if (lattice_) {
      if (const bonds::StencilOffset* offset = lattice_->remove(bond[0], bond[1])) {
        length = offset->length;
        square = offset->influence * offset->share * length * length;
      }
    } else {
      const bonds::PairFamilies::Removed removed = pairs_->remove(bond[0], bond[1]);
      length = removed.length;
      square = removed.weight * length * length;
    }
    if (square == 0) throw std::logic_error("a bond that is not there cannot break");
    for (const int end : {0, 1}) {
      const LocalIndex i = bond[static_cast<std::size_t>(end)], j = bond[static_cast<std::size_t>(1 - end)];
      if (i >= body_.owned) continue;
      // Of what there was before any crack, this much was left: 1 - damage.
      const double lost = square * body_.volume[j], all = families_.weighted_volume[i];
      families_.damage[i] += (1 - families_.damage[i]) * lost / (all - families_.broken_volume[i]);
      families_.broken_volume[i] += lost;
      keep_extension(i, j, lost / (length * length), length, extension[end]);
      if (--families_.size[i] == 0) {
        families_.damage[i] = 1;
        families_.broken_volume[i] = all;
        if (!families_.broken_extension.empty()) families_.broken_extension[static_cast<std::size_t>(i)] = {};
      }
      --families_.directed;
      ++families_.broken;
    }
    const std::array<GlobalId, 2> ids{body_.id[bond[0]], body_.id[bond[1]]};
    const bool first = ids[0] < ids[1];
    if (bond[first ? 0 : 1] < body_.owned) broken_.push_back({std::min(ids[0], ids[1]), std::max(ids[0], ids[1])});
  }
  bonds_.reset();
  basis_.clear();
}

const bonds::Bonds& Scene::bonds() const {
  if (bonds_) return *bonds_;
  bonds_ = std::make_unique<bonds::Bonds>();
  bonds::Bonds& all = *bonds_;
  static_cast<bonds::Families&>(all) = families_;
  all.offset.push_back(0);
  std::vector<bonds::FoundBond> family;
  if (lattice_) {
    std::vector<bonds::LatticeFamilies::Place> places;
    for (LocalIndex i = 0; i < body_.owned; ++i) {
      lattice_->places(i, places);
      family.clear();
      for (const auto& place : places) {
        const bonds::StencilOffset& offset = lattice_->offsets()[place.offset];
        family.push_back(
            {place.neighbor, offset.length, offset.share * body_.volume[place.neighbor], offset.influence});
      }
      add_family(all, family, body_);
    }
    return all;
  }
  const auto every = pairs_->places();
  for (LocalIndex i = 0; i < body_.owned; ++i) {
    family.clear();
    for (const auto& place : every[i]) {
      const double length = pairs_->length()[place.pair];
      const double influence = bonds::influence_value(families_.influence, length, families_.horizon);
      const double weight = pairs_->weight().empty() ? 1 : pairs_->weight()[place.pair];
      family.push_back({place.neighbor, length, weight / influence * body_.volume[place.neighbor], influence});
    }
    add_family(all, family, body_);
  }
  return all;
}

bonds::BondGraph Scene::bond_graph() const {
  if (lattice_)
    return [this, places = std::vector<bonds::LatticeFamilies::Place>()](LocalIndex i,
                                                                         std::vector<LocalIndex>& neighbors) mutable {
      lattice_->places(i, places);
      neighbors.clear();
      for (const auto& place : places) neighbors.push_back(place.neighbor);
    };
  return pairs_->graph();
}

materials::Family Scene::family(LocalIndex i) const {
  const bonds::Bonds& all = bonds();
  const auto first = static_cast<std::size_t>(all.offset[i]);
  materials::Family family;
  family.dimension = body_.dimension;
  family.count = all.family_size(i);
  family.length = all.length.data() + first;
  family.influence = all.influence.data() + first;
  family.weight = all.weight.data() + first;
  family.weighted_volume = all.weighted_volume[i];
  if (!all.deviatoric_volume.empty()) family.deviatoric_volume = all.deviatoric_volume[i];
  family.continuum_weighted_volume = all.continuum_weighted_volume;
  family.moment = families_.moment(i);
  if (!all.broken_volume.empty()) family.broken_volume = all.broken_volume[i];
  if (!all.broken_extension.empty()) family.broken_extension = all.broken_extension[static_cast<std::size_t>(i)];
  if (family.moment) family.basis = basis().data() + first * bonds::mandel_size(dimension());
  return family;
}

const std::vector<double>& Scene::basis() const {
  if (!basis_.empty()) return basis_;
  const bonds::Bonds& all = bonds();
  const int n = bonds::mandel_size(dimension());
  basis_.resize(static_cast<std::size_t>(all.count()) * n);
  for (LocalIndex i = 0; i < body_.owned; ++i)
    for (std::int64_t b = all.offset[i]; b < all.offset[i + 1]; ++b) {
      double between[3] = {};
      for (int c = 0; c < dimension(); ++c)
        between[c] = (body_.position(all.neighbor[b])[c] - body_.position(i)[c]) / all.length[b];
      const bonds::Mandel direction = bonds::mandel(dimension(), between, all.length[b]);
      std::copy_n(direction.begin(), n, basis_.begin() + b * n);
    }
  return basis_;
}

bool Scene::symmetric() const {
  return std::all_of(materials_.begin(), materials_.end(), [](const auto& material) { return material->symmetric(); });
}

bool Scene::remembers() const {
  return std::any_of(materials_.begin(), materials_.end(), [](const auto& material) {
    const materials::HistoryLayout layout = material->history();
    return !layout.point.empty() || layout.per_bond > 0;
  });
}

std::optional<medium::LocalElasticity> Scene::local_elasticity() const {
  medium::LocalElasticity elasticity;
  for (const auto& material : materials_) elasticity.moduli.push_back(material->elastic_moduli(dimension()));
  elasticity.regular = lattice_ != nullptr;
  elasticity.damage = &families_.damage;
  return elasticity;
}

std::vector<std::string> Scene::point_history_names() const {
  std::vector<std::string> names;
  for (const auto& material : materials_)
    for (const std::string& name : material->history().point)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

Scene build_scene(const deck::Deck& deck, const Communicator& communicator, body::PartitionReport* report) {
  // Materials first: a wrong constant is said before any particle is made.
  std::vector<std::unique_ptr<materials::Material>> materials;
  for (const deck::Material& material : deck.materials) materials.push_back(materials::make(material, deck.dimension));
  const double horizon = body::horizon_length(deck, communicator);
  const double reach = bonds::reach(deck, horizon, body::largest_spacing(deck, communicator));
  body::Body body = body::build(deck, communicator, reach, report);
  return Scene(deck, std::move(body), horizon, std::move(materials));
}

}  // namespace perinox::mechanics
