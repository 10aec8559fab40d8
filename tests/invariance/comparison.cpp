/// Finds how far two answers are apart.
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "answer.hpp"

namespace perinox::invariance {

namespace {

/// Finds the particle nearest to a place, if it is nearer than a tenth of the spacing.
class Places {
 public:
  Places(const std::vector<double>& place, double spacing) : place_(place), cell_(spacing) {
    for (std::size_t i = 0; 3 * i < place.size(); ++i) at_.emplace(key(cell(&place[3 * i], 0)), i);
  }
  long long find(const Vector3& x) const {
    long long found = -1;
    double nearest = 0.1 * cell_;
    for (int neighbor = 0; neighbor < 27; ++neighbor) {
      const auto [begin, end] = at_.equal_range(key(cell(x.data(), neighbor)));
      for (auto entry = begin; entry != end; ++entry) {
        const double* y = &place_[3 * entry->second];
        const double apart = std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]);
        if (apart < nearest) nearest = apart, found = static_cast<long long>(entry->second);
      }
    }
    return found;
  }

 private:
  using Cell = std::array<long long, 3>;
  Cell cell(const double* x, int neighbor) const {
    const int step[3] = {neighbor % 3, neighbor / 3 % 3, neighbor / 9};
    Cell c{};
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = static_cast<long long>(std::floor(x[k] / cell_)) + (step[k] == 2 ? -1 : step[k]);
    return c;
  }
  static std::size_t key(const Cell& c) {
    std::size_t hash = 0;
    for (const long long part : c) hash = hash * 1000003U + std::hash<long long>{}(part);
    return hash;
  }

  const std::vector<double>& place_;
  double cell_;
  std::unordered_multimap<std::size_t, std::size_t> at_;
};

/// The difference of two numbers. It is infinite if either is not finite.
double gap(double found, double wanted) {
  const double apart = std::abs(found - wanted);
  return std::isfinite(apart) ? apart : std::numeric_limits<double>::infinity();
}

/// The largest of several deviations, and its name.
struct Worst {
  double value = 0;
  std::string what;
  void take(double difference, double size, const std::string& name) {
    const double relative = size > 0 ? difference / size : (difference > 0 ? 1 : 0);
    if (relative > value) value = relative, what = name;
  }
};

enum class Kind { length, force, stress, energy_density, scalar };
const std::map<std::string, Kind> kinds{{"displacement", Kind::length},
                                        {"force", Kind::force},
                                        {"stress", Kind::stress},
                                        {"von_mises_stress", Kind::stress},
                                        {"strain", Kind::scalar},
                                        {"dilatation", Kind::scalar},
                                        {"damage", Kind::scalar},
                                        {"stored_energy", Kind::energy_density},
                                        {"plastic_work", Kind::energy_density},
                                        {"velocity", Kind::length},
                                        {"equivalent_plastic_strain", Kind::scalar},
                                        {"plastic_strain_zz", Kind::scalar}};

class Comparison {
 public:
  Comparison(const Answer& base, const Answer& changed, const Transformation& change)
      : base_(base), changed_(changed), change_(change), d_(base.dimension) {}

  void particles(bool more) {
    const std::size_t count = base_.volume.size();
    if (changed_.volume.size() < count || (!more && changed_.volume.size() != count)) worst_.take(1, 1, "particles");
    const Places places(changed_.place, changed_.spacing);
    for (std::size_t i = 0; i < count; ++i) {
      partner_.push_back(
          places.find(change_.place({base_.place[3 * i], base_.place[3 * i + 1], base_.place[3 * i + 2]})));
      if (partner_.back() < 0) {
        worst_.take(1, 1, "place of a particle");
        continue;
      }
      const auto j = static_cast<std::size_t>(partner_.back());
      const double volume = base_.volume[i] * std::pow(change_.length, d_);
      worst_.take(std::abs(changed_.volume[j] - volume), volume, "volume");
      if (changed_.family[j] != base_.family[i]) worst_.take(1, 1, "bonds of a particle");
    }
  }

  void field(const std::string& name, const FieldValues& old) {
    const auto kind = kinds.find(name);
    const auto made = changed_.fields.find(name);
    if (kind == kinds.end()) return;
    if (made == changed_.fields.end()) return worst_.take(1, 1, name + " is missing");
    const double factor = factor_of(kind->second);
    const auto n = static_cast<std::size_t>(old.components);
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < partner_.size(); ++i) {
      if (partner_[i] < 0) continue;
      const std::array<double, 6> wanted = turned(&old.values[i * n], old.components);
      for (std::size_t c = 0; c < n; ++c) {
        const double found = made->second.values[static_cast<std::size_t>(partner_[i]) * n + c];
        difference = std::max(difference, gap(found, factor * wanted[c]));
        size = std::max(size, std::abs(factor * wanted[c]));
      }
    }
    worst_.take(difference, size, name);
  }

  void rows(bool all) {
    if (changed_.rows.empty() != base_.rows.empty()) return worst_.take(1, 1, "steps");
    if (base_.rows.empty()) return;
    if (all && base_.rows.size() != changed_.rows.size()) return worst_.take(1, 1, "steps");
    const std::size_t count = all ? base_.rows.size() : 1;
    // Sums over particles may cancel. Their rounding is that of the terms.
    const double forces = sum_of("force"), ways = largest_of("displacement");
    const auto column = [&](auto values, double factor, double least, const std::string& name) {
      double difference = 0, size = factor * least;
      for (std::size_t k = 0; k < count; ++k) {
        const auto& old = base_.rows[base_.rows.size() - count + k].*values;
        const auto& made = changed_.rows[changed_.rows.size() - count + k].*values;
        for (std::size_t e = 0; e < std::min(old.size(), made.size()); ++e) {
          difference = std::max(difference, gap(std::abs(made[e]), std::abs(factor * old[e])));
          size = std::max(size, std::abs(factor * old[e]));
        }
      }
      worst_.take(difference, size, name);
    };
    using Row = Answer::Row;
    const double force = change_.stress * std::pow(change_.length, d_ - 1);
    column(&Row::energies, force * change_.length, 0, "energies");
    column(&Row::reactions, force, forces, "reactions");
    column(&Row::movements, change_.length, ways, "movements");
    column(&Row::shares, 1, 0, "yielded");
  }

  Worst& worst() { return worst_; }

 private:
  double sum_of(const std::string& field) const {
    double sum = 0;
    if (base_.fields.count(field))
      for (const double value : base_.fields.at(field).values) sum += std::abs(value);
    return sum;
  }
  double largest_of(const std::string& field) const {
    double most = 0;
    if (base_.fields.count(field))
      for (const double value : base_.fields.at(field).values) most = std::max(most, std::abs(value));
    return most;
  }
  double factor_of(Kind kind) const {
    switch (kind) {
      case Kind::length:
        return change_.length;
      case Kind::force:
        return change_.stress * std::pow(change_.length, d_ - 1);
      case Kind::stress:
      case Kind::energy_density:
        return change_.stress;
      default:
        return 1;
    }
  }
  std::array<double, 6> turned(const double* values, int components) const {
    if (components == 6) return change_.tensor(values);
    if (components == 1) return {values[0]};
    const Vector3 v = change_.direction({values[0], values[1], components == 3 ? values[2] : 0});
    return {v[0], v[1], v[2]};
  }

  const Answer &base_, &changed_;
  const Transformation& change_;
  int d_;
  Worst worst_;
  std::vector<long long> partner_;
};

}  // namespace

double deviation(const Answer& base, const Answer& changed, const Transformation& change, Rows rows, bool more,
                 std::string* what) {
  Comparison comparison(base, changed, change);
  Worst& worst = comparison.worst();
  if (base.refused.empty() != changed.refused.empty())
    worst.take(1, 1, "refused: " + base.refused + changed.refused);
  else if (base.stopped.empty() != changed.stopped.empty())
    worst.take(1, 1, "stopped: " + base.stopped + changed.stopped);
  else if (base.refused.empty()) {
    comparison.particles(more);
    for (const auto& [name, values] : base.fields) comparison.field(name, values);
    if (rows != Rows::none) comparison.rows(rows == Rows::all);
  }
  if (what) *what = worst.what;
  return worst.value;
}

}  // namespace perinox::invariance
