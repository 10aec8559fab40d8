#include "perinox/motion/contact.hpp"

#include <algorithm>
#include <cmath>

namespace perinox::motion {

namespace {
/// Of the largest reach: a list lasts until a particle has gone half of it.
constexpr double margin = 0.5;
constexpr int most_contacts = 6;
}  // namespace

Contact::Contact(const mechanics::Scene& scene, const deck::Contact& settings)
    : scene_(scene),
      settings_(settings),
      d_(scene.dimension()),
      near_(scene, largest_reach(), margin * largest_reach()) {
  find_stiffness();
}

double Contact::largest_reach() const {
  double widest = 0;
  for (LocalIndex i = 0; i < scene_.owned(); ++i) widest = std::max(widest, scene_.body().spacing_of(i));
  return settings_.distance * scene_.body().communicator.max(widest);
}

void Contact::find_stiffness() {
  const bonds::Families& families = scene_.families();
  stiffness_.resize(static_cast<std::size_t>(scene_.owned()));
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const double spacing = scene_.body().spacing_of(i);
    const double alpha = d_ * (d_ + 2) * scene_.material(i).elastic_moduli(d_).shear / families.weighted_volume[i];
    stiffness_[i] =
        alpha * bonds::influence_value(families.influence, std::min(spacing, families.horizon), families.horizon);
  }
}

void Contact::make_springs() {
  constexpr int count = 3;  // spacing, volume, alpha omega
  std::vector<double> values;
  for (const LocalIndex i : near_.particle()) {
    const double spacing = scene_.body().spacing_of(i);
    values.insert(values.end(), {spacing, scene_.body().volume[i], stiffness_[i]});
  }
  values = near_.share(std::move(values), count);
  springs_.clear();
  for (const auto& [one, other] : near_.pairs()) {
    const double *a = &values[static_cast<std::size_t>(one) * count],
                 *b = &values[static_cast<std::size_t>(other) * count];
    double square = 0;
    for (int c = 0; c < d_; ++c) {
      const double between = near_.reference(other)[c] - near_.reference(one)[c];
      square += between * between;
    }
    // Of the coarser one: a fine body must not find a way between the particles of a coarse one.
    const double reach = std::min(settings_.distance * std::max(a[0], b[0]), std::sqrt(square));
    springs_.push_back({reach, settings_.stiffness * (a[1] * b[1]) * (a[2] + b[2])});
  }
}

double Contact::add_forces(const double* displacement, double* force) {
  if (near_.move(displacement)) make_springs();
  const auto d = static_cast<std::size_t>(d_);
  double energy = 0;
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    const auto [one, other] = near_.pairs()[k];
    const double *a = near_.place(one), *b = near_.place(other);
    double between[3], square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      between[c] = b[c] - a[c];
      square += between[c] * between[c];
    }
    const Spring& spring = springs_[k];
    if (square >= spring.reach * spring.reach || square == 0) continue;
    const double distance = std::sqrt(square), pressed = spring.reach - distance;
    const bool here = other < near_.own();
    energy += (here ? 0.5 : 0.25) * spring.stiffness * pressed * pressed;
    const double push = spring.stiffness * pressed / distance;
    double* on = force + static_cast<std::size_t>(near_.particle()[static_cast<std::size_t>(one)]) * d;
    for (std::size_t c = 0; c < d; ++c) on[c] -= push * between[c];
    if (!here) continue;
    double* back = force + static_cast<std::size_t>(near_.particle()[static_cast<std::size_t>(other)]) * d;
    for (std::size_t c = 0; c < d; ++c) back[c] += push * between[c];
  }
  return energy;
}

void Contact::save(StateWriter& writer) const { writer.particles("contact/listed", near_.listed().data(), d_); }

void Contact::restore(StateReader& reader) {
  near_.list_again(reader.particles("contact/listed", d_));
  make_springs();
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

}  // namespace perinox::motion
