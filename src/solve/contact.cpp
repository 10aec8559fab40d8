#include "perinox/solve/contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
namespace perinox::solve {

namespace {
/// Distance of particle i from its neighbours: on a lattice it does not go by the part of a cell that i stands for.
double spacing_of(const body::Body& body, LocalIndex i) {
  return body.spacing > 0 ? body.spacing : std::pow(body.volume[i], 1.0 / body.dimension);
}

/// Mean of the bonds' directions from which a particle counts as exposed: 0.5 on a flat face, about 0.15 one layer
/// below it at three spacings, at most 0.09 from the scatter of a cloud.
constexpr double lopsided = 0.12;
/// Share of the largest family's bonds below which a particle counts as exposed.
constexpr double few = 0.75;
/// Of the largest reach: a list lasts until a particle has gone half of it.
constexpr double margin = 0.5;
constexpr int most_contacts = 6;

/// One array from every rank to every rank. counts: doubles.
std::vector<double> all_to_all(MPI_Comm comm, const std::vector<double>& out, const std::vector<int>& out_count,
                               const std::vector<int>& in_count) {
  const auto starts = [](const std::vector<int>& count) {
    std::vector<int> begin{0};
    for (const int c : count) begin.push_back(begin.back() + c);
    return begin;
  };
  const std::vector<int> from = starts(out_count), to = starts(in_count);
  std::vector<double> in(static_cast<std::size_t>(to.back()));
  MPI_Alltoallv(out.data(), out_count.data(), from.data(), MPI_DOUBLE, in.data(), in_count.data(), to.data(),
                MPI_DOUBLE, comm);
  return in;
}
}  // namespace

Contact::Contact(const mechanics::Scene& scene, const deck::Contact& settings)
    : scene_(scene), settings_(settings), d_(scene.dimension()), stiffness_(static_cast<std::size_t>(scene.owned())) {
  double widest = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    const double spacing = spacing_of(scene.body(), i);
    widest = std::max(widest, spacing);
    const double mu = scene.material(i).elastic_moduli(d_).shear;
    const double alpha = d_ * (d_ + 2) * mu / scene.families().weighted_volume[i];
    stiffness_[i] =
        alpha * bonds::influence_value(scene.families().influence, std::min(spacing, scene.families().horizon),
                                       scene.families().horizon);
  }
  largest_reach_ = settings.distance * scene.body().communicator.max(widest);
  margin_ = margin * largest_reach_;
  refresh();
}

void Contact::refresh() {
  find_exposed();
  listed_once_ = false;
}

void Contact::find_exposed() {
  const body::Body& body = scene_.body();
  const bonds::BondGraph graph = scene_.bond_graph();
  std::vector<LocalIndex> neighbors;
  double largest = 0;
  for (LocalIndex i = 0; i < scene_.owned(); ++i) largest = std::max<double>(largest, scene_.families().size[i]);
  largest = body.communicator.max(largest);
  particle_.clear();
  own_.clear();
  bonded_.clear();
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    graph(i, neighbors);
    std::array<double, 3> sum{};
    for (const LocalIndex j : neighbors) {
      double between[3] = {}, square = 0;
      for (int c = 0; c < d_; ++c) {
        between[c] = body.position(j)[c] - body.position(i)[c];
        square += between[c] * between[c];
      }
      for (int c = 0; c < d_; ++c) sum[c] += between[c] / std::sqrt(square);
    }
    const auto count = static_cast<double>(neighbors.size());
    const double norm = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    if (count >= few * largest && norm <= lopsided * count) continue;
    Point point;
    point.id = body.id[i];
    for (int c = 0; c < d_; ++c) point.reference[c] = body.position(i)[c];
    point.volume = body.volume[i];
    point.spacing = spacing_of(body, i);
    point.stiffness = stiffness_[i];
    particle_.push_back(i);
    own_.push_back(point);
    std::vector<GlobalId>& ids = bonded_.emplace_back();
    for (const LocalIndex j : neighbors) ids.push_back(body.id[j]);
    std::sort(ids.begin(), ids.end());
  }
}

void Contact::place_own(const double* displacement) {
  const auto d = static_cast<std::size_t>(d_);
  place_.resize((own_.size() + other_.size()) * d);
  for (std::size_t k = 0; k < own_.size(); ++k)
    for (std::size_t c = 0; c < d; ++c)
      place_[k * d + c] = own_[k].reference[c] + displacement[static_cast<std::size_t>(particle_[k]) * d + c];
}

bool Contact::moved_too_far() const {
  const auto d = static_cast<std::size_t>(d_);
  double most = 0;
  for (std::size_t k = 0; k < own_.size(); ++k) {
    double square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      const double step = place_[k * d + c] - listed_[k * d + c];
      square += step * step;
    }
    most = std::max(most, square);
  }
  return !(most <= 0.25 * margin_ * margin_);  // also where it is not a number
}

double Contact::add_forces(const double* displacement, double* force) {
  place_own(displacement);
  const Communicator& ranks = scene_.body().communicator;
  const bool stale = !listed_once_ || moved_too_far();
  if (ranks.size() > 1 ? ranks.any(stale) : stale)
    make_list();
  else if (ranks.size() > 1)
    exchange_places();
  const auto d = static_cast<std::size_t>(d_);
  const auto own = static_cast<int>(own_.size());
  double energy = 0;
  for (const Pair& pair : pairs_) {
    const double* a = &place_[static_cast<std::size_t>(pair.own) * d];
    const double* b = &place_[static_cast<std::size_t>(pair.other) * d];
    double between[3], square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      between[c] = b[c] - a[c];
      square += between[c] * between[c];
    }
    if (square >= pair.reach * pair.reach || square == 0) continue;
    const double distance = std::sqrt(square), pressed = pair.reach - distance;
    const bool here = pair.other < own;
    energy += (here ? 0.5 : 0.25) * pair.stiffness * pressed * pressed;
    const double push = pair.stiffness * pressed / distance;
    double* on = force + static_cast<std::size_t>(particle_[static_cast<std::size_t>(pair.own)]) * d;
    for (std::size_t c = 0; c < d; ++c) on[c] -= push * between[c];
    if (!here) continue;
    double* back = force + static_cast<std::size_t>(particle_[static_cast<std::size_t>(pair.other)]) * d;
    for (std::size_t c = 0; c < d; ++c) back[c] += push * between[c];
  }
  return energy;
}

void Contact::make_list() {
  ++lists_;
  listed_once_ = true;
  listed_.assign(place_.begin(), place_.begin() + static_cast<std::ptrdiff_t>(own_.size()) * d_);
  if (scene_.body().communicator.size() > 1) exchange_points();
  pairs_.clear();
  const auto d = static_cast<std::size_t>(d_);
  // What is not a number has no place in a tree; the energies tell that the run is over.
  if (place_.empty() || !std::all_of(place_.begin(), place_.end(), [](double x) { return std::isfinite(x); })) return;
  const body::NeighborSearch search(place_, d_);
  std::vector<LocalIndex> found;
  const auto own = static_cast<int>(own_.size());
  const auto point = [&](int k) -> const Point& { return k < own ? own_[k] : other_[k - own]; };
  for (int i = 0; i < own; ++i) {
    search.within(&place_[static_cast<std::size_t>(i) * d], largest_reach_ + margin_, found);
    for (const LocalIndex j : found) {
      if (j < own && j <= i) continue;
      const Point &a = point(i), &b = point(j);
      if (std::binary_search(bonded_[i].begin(), bonded_[i].end(), b.id)) continue;
      double square = 0;
      for (std::size_t c = 0; c < d; ++c) {
        const double between = b.reference[c] - a.reference[c];
        square += between * between;
      }
      const double reach = std::min(settings_.distance * 0.5 * (a.spacing + b.spacing), std::sqrt(square));
      pairs_.push_back({i, j, reach, settings_.stiffness * (a.volume * b.volume) * (a.stiffness + b.stiffness)});
    }
  }
}

void Contact::save(StateWriter& writer) const {
  const auto d = static_cast<std::size_t>(d_);
  std::vector<double> places(scene_.owned_unknowns(), 0.0);
  for (std::size_t k = 0; k < own_.size(); ++k)
    std::copy_n(&listed_[k * d], d, &places[static_cast<std::size_t>(particle_[k]) * d]);
  writer.particles("contact/listed", places.data(), d_);
}

void Contact::restore(StateReader& reader) {
  const auto d = static_cast<std::size_t>(d_);
  const std::vector<double> places = reader.particles("contact/listed", d_);
  place_.resize(own_.size() * d);
  for (std::size_t k = 0; k < own_.size(); ++k)
    std::copy_n(&places[static_cast<std::size_t>(particle_[k]) * d], d, &place_[k * d]);
  make_list();
}

void Contact::exchange_points() {
  const Communicator& ranks = scene_.body().communicator;
  const auto d = static_cast<std::size_t>(d_), size = static_cast<std::size_t>(ranks.size());
  // Boxes of all ranks, wider by the reach of a list; where a rank has no exposed particle its box is empty.
  std::vector<double> box;
  for (std::size_t c = 0; c < d; ++c) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t k = 0; k < own_.size(); ++k) {
      low = std::min(low, place_[k * d + c]);
      high = std::max(high, place_[k * d + c]);
    }
    box.push_back(low - largest_reach_ - margin_);
    box.push_back(high + largest_reach_ + margin_);
  }
  const std::vector<double> boxes = ranks.gather(box);
  out_.clear();
  out_count_.assign(size, 0);
  in_count_.assign(size, 0);
  for (std::size_t r = 0; r < size; ++r) {
    if (static_cast<int>(r) == ranks.rank()) continue;
    const double* other = &boxes[r * 2 * d];
    for (std::size_t k = 0; k < own_.size(); ++k) {
      bool inside = true;
      for (std::size_t c = 0; c < d; ++c)
        inside = inside && place_[k * d + c] >= other[2 * c] && place_[k * d + c] <= other[2 * c + 1];
      if (!inside) continue;
      out_.push_back(static_cast<int>(k));
      ++out_count_[r];
    }
  }
  MPI_Alltoall(out_count_.data(), 1, MPI_INT, in_count_.data(), 1, MPI_INT, ranks.mpi());
  std::vector<double> out;
  for (const int k : out_) {
    const Point& point = own_[static_cast<std::size_t>(k)];
    out.insert(out.end(), {static_cast<double>(point.id), point.reference[0], point.reference[1], point.reference[2],
                           point.volume, point.spacing, point.stiffness});
  }
  const auto times = [](std::vector<int> counts, std::size_t n) {
    for (int& count : counts) count *= static_cast<int>(n);
    return counts;
  };
  const std::vector<double> in = all_to_all(ranks.mpi(), out, times(out_count_, sent), times(in_count_, sent));
  other_.resize(in.size() / sent);
  for (std::size_t k = 0; k < other_.size(); ++k) {
    const double* from = &in[k * sent];
    other_[k] = {static_cast<GlobalId>(from[0]), {from[1], from[2], from[3]}, from[4], from[5], from[6]};
  }
  exchange_places();
}

void Contact::exchange_places() {
  const auto d = static_cast<std::size_t>(d_);
  place_.resize((own_.size() + other_.size()) * d);
  std::vector<double> out;
  for (const int k : out_)
    out.insert(out.end(), &place_[static_cast<std::size_t>(k) * d], &place_[static_cast<std::size_t>(k) * d] + d);
  std::vector<int> out_count = out_count_, in_count = in_count_;
  for (int& count : out_count) count *= d_;
  for (int& count : in_count) count *= d_;
  const std::vector<double> in = all_to_all(scene_.body().communicator.mpi(), out, out_count, in_count);
  std::copy(in.begin(), in.end(), place_.begin() + static_cast<std::ptrdiff_t>(own_.size() * d));
}

double Contact::largest_eigenvalue(const std::vector<double>& masses) const {
  // A spring k between i and j adds at most 2k/m to the rows of either end (Gershgorin).
  double largest = 0;
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const double volume = scene_.body().volume[i];
    const double spring = settings_.stiffness * volume * volume * 2 * stiffness_[i];
    largest = std::max(largest, 2 * most_contacts * spring / masses[i]);
  }
  return scene_.body().communicator.max(largest);
}

}  // namespace perinox::solve
