#include "perinox/loads/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/core/sentence.hpp"
#include "perinox/loads/rigid_modes.hpp"

namespace perinox::loads {

namespace {
constexpr const char* axis = "xyz";

bool prescribes(deck::LoadKind kind) {
  return kind == deck::LoadKind::displacement || kind == deck::LoadKind::velocity;
}
bool on_surface(deck::LoadKind kind) { return kind == deck::LoadKind::traction || kind == deck::LoadKind::pressure; }

/// A table that is not what a load over all of the run looks like; "" if it is.
std::string remark_on(const body::FieldTable& table, const deck::Load& load, const deck::Deck& deck) {
  if (!table.has_time() && deck.dynamics == deck::Dynamics::quasi_static && deck.steps.count > 1)
    return deck::placed(
        load.table_location,
        "the table has no column t, so that its displacements are there in full from the first step on");
  const double last = table.times().back(), end = deck.steps.end;
  if (!table.has_time() || last >= end * (1 - 1e-9)) return "";
  return deck::placed(load.table_location,
                      fmt::format("the table ends at t = {:g}, before steps.end = {:g}; its last displacements stay "
                                  "from there on",
                                  last, end));
}
}  // namespace

Boundary::Boundary(const deck::Deck& deck, const medium::Model& model) : model_(model) {
  const body::Body& body = model.body();
  const int d = body.dimension;
  std::vector<double> mark(model.local_unknowns(), 0.0);
  std::vector<int> prescriber(model.owned_unknowns(), -1);

  for (const deck::Load& load : deck.boundary) {
    Entry entry{&load, &body.sets.at(load.set), std::nullopt, 0};
    const int number = static_cast<int>(entries_.size());
    long long twice = 0;
    if (prescribes(load.kind)) {
      if (load.table) {
        entry.table.emplace(*load.table, load.table_location, body, *entry.set);
        if (std::string remark = remark_on(*entry.table, load, deck); !remark.empty())
          remarks_.push_back(std::move(remark));
      }
      for (int c = 0; c < d; ++c) {
        if (!load.table && !load.component[c]) continue;
        for (const LocalIndex i : *entry.set) {
          const auto unknown = static_cast<std::size_t>(i) * d + c;
          mark[unknown] = 1;
          if (prescriber[unknown] >= 0 && prescriber[unknown] != number) ++twice;
          prescriber[unknown] = number;
        }
      }
    } else if (on_surface(load.kind)) {
      entry.faces = body::exposed_faces(deck, body, *entry.set, load.location, load.facing);
    } else {
      for (const LocalIndex i : *entry.set) entry.set_volume += body.volume[i];
      entry.set_volume = body.communicator.sum(entry.set_volume);
    }
    twice = body.communicator.sum(twice);
    if (twice > 0)
      remarks_.push_back(
          fmt::format("{}: prescribes {} unknowns that an earlier entry prescribes too; this later one "
                      "counts",
                      load.location.text(), twice));
    entries_.push_back(std::move(entry));
  }

  take_prescribed(mark, prescriber);
  if (deck.dynamics == deck::Dynamics::quasi_static) {
    if (prescribed_count_ == 0)
      deck::refuse(
          deck.resolved.at("boundary").location(),
          "nothing holds the body: no displacement is prescribed anywhere; add a boundary entry with displacement");
    refuse_free_pieces(deck, model, prescribed_);
  } else {
    model_.body().communicator.agree_on_input_error(first_not_finite(0));
  }
  model_.body().communicator.agree_on_input_error(
      first_not_finite(deck.steps.count > 0 ? deck.steps.end / deck.steps.count : deck.steps.end));
  model_.body().communicator.agree_on_input_error(first_not_finite(deck.steps.end));
  keep_steady_values();
  remark_on_reversals(deck);
}

/// mark: [local * dimension], 1 where an entry prescribes something; prescriber: [owned * dimension] the last one that
/// does, or -1. Collective.
void Boundary::take_prescribed(std::vector<double>& mark, const std::vector<int>& prescriber) {
  model_.body().halo.update_ghosts(mark.data(), model_.dimension());
  prescribed_.assign(mark.size(), 0);
  std::transform(mark.begin(), mark.end(), prescribed_.begin(), [](double m) { return static_cast<char>(m != 0); });
  count_unknowns();
  for (std::size_t u = 0; u < prescriber.size(); ++u) {
    if (prescriber[u] < 0 || entries_[static_cast<std::size_t>(prescriber[u])].load->kind != deck::LoadKind::velocity)
      continue;
    driven_by_velocity_.resize(prescriber.size(), 0);
    driven_by_velocity_[u] = 1;
  }
}

void Boundary::keep_steady_values() {
  for (Entry& entry : entries_) {
    const bool force = !prescribes(entry.load->kind);
    has_forces_ = has_forces_ || force;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& expression = entry.load->component[c];
      if (!expression) continue;
      if (expression->uses_time()) {
        forces_change_ = forces_change_ || force;
      } else if (!force) {
        for (const LocalIndex i : *entry.set) entry.steady[c].push_back(value(entry, static_cast<int>(c), i, 0));
      }
    }
  }
}

double Boundary::value_of(const Entry& entry, int component, std::size_t k, double t) const {
  const std::vector<double>& steady = entry.steady[static_cast<std::size_t>(component)];
  return steady.empty() ? value(entry, component, (*entry.set)[k], t) : steady[k];
}

void Boundary::count_unknowns() {
  const auto end = prescribed_.begin() + static_cast<std::ptrdiff_t>(model_.owned_unknowns());
  prescribed_count_ = model_.body().communicator.sum(static_cast<long long>(std::count(prescribed_.begin(), end, 1)));
  free_count_ = model_.body().total * model_.dimension() - prescribed_count_;
}

void Boundary::let_go(const std::vector<char>& loose) {
  const int d = model_.dimension();
  std::vector<double> mark(prescribed_.begin(), prescribed_.end());
  loose_.resize(static_cast<std::size_t>(model_.owned()), 0);
  for (LocalIndex i = 0; i < model_.owned(); ++i) {
    if (!loose[i]) continue;
    loose_[i] = 1;
    std::fill_n(mark.begin() + static_cast<std::ptrdiff_t>(i) * d, d, 1.0);
  }
  model_.body().halo.update_ghosts(mark.data(), d);
  std::transform(mark.begin(), mark.end(), prescribed_.begin(), [](double m) { return static_cast<char>(m != 0); });
  count_unknowns();
}

double Boundary::value(const Entry& entry, int component, LocalIndex i, double t) const {
  const auto& expression = entry.load->component[component];
  if (!expression) return 0;
  const deck::Point x = model_.body().position3(i);
  return (*expression)(x[0], x[1], x[2], t);
}

std::string Boundary::not_finite(double t) const {
  return first_sentence(model_.body().communicator, first_not_finite(t));
}

std::string Boundary::first_not_finite(double t) const {
  for (const Entry& entry : entries_) {
    if (entry.table) continue;
    const bool pressure = entry.load->kind == deck::LoadKind::pressure;
    for (int c = 0; c < (pressure ? 1 : model_.dimension()); ++c)
      for (const LocalIndex i : *entry.set) {
        if (std::isfinite(value(entry, c, i, t))) continue;
        const deck::Point x = model_.body().position3(i);
        return fmt::format(
            "{}: the {} is not a finite number at ({:g}, {:g}, {:g}) for t = {:g}; check "
            "the formula {}",
            entry.load->location.text(), pressure ? "pressure" : fmt::format("{} component", axis[c]), x[0], x[1], x[2],
            t, entry.load->component[c]->text());
      }
  }
  return "";
}

void Boundary::impose(double t, double* displacement) const {
  const int d = model_.dimension();
  for (const Entry& entry : entries_) {
    if (entry.load->kind != deck::LoadKind::displacement) continue;
    for (std::size_t k = 0; k < entry.set->size(); ++k) {
      const LocalIndex i = (*entry.set)[k];
      if (!loose_.empty() && loose_[i]) continue;
      double* u = displacement + static_cast<std::size_t>(i) * d;
      if (entry.table) {
        entry.table->evaluate(k, t, u);
        continue;
      }
      for (int c = 0; c < d; ++c)
        if (entry.load->component[c]) u[c] = value_of(entry, c, k, t);
    }
  }
}

void Boundary::impose_velocity(double t, double* velocity) const {
  if (driven_by_velocity_.empty()) return;
  const auto d = static_cast<std::size_t>(model_.dimension());
  for (const Entry& entry : entries_) {
    if (entry.load->kind != deck::LoadKind::velocity) continue;
    for (std::size_t k = 0; k < entry.set->size(); ++k)
      for (std::size_t c = 0; c < d; ++c) {
        const std::size_t u = static_cast<std::size_t>((*entry.set)[k]) * d + c;
        if (entry.load->component[c] && driven_by_velocity_[u] && (loose_.empty() || !loose_[u / d]))
          velocity[u] = value_of(entry, static_cast<int>(c), k, t);
      }
  }
}

void Boundary::external_force(double t, double* force) const {
  const int d = model_.dimension();
  std::fill(force, force + model_.owned_unknowns(), 0.0);
  for (const Entry& entry : entries_) {
    if (prescribes(entry.load->kind)) continue;
    if (on_surface(entry.load->kind)) {
      add_surface_force(entry, t, force);
      continue;
    }
    const bool total = entry.load->kind == deck::LoadKind::force;
    for (int c = 0; c < d; ++c) {
      if (!entry.load->component[c]) continue;
      for (const LocalIndex i : *entry.set) {
        const double share = total ? model_.body().volume[i] / entry.set_volume : model_.body().volume[i];
        force[static_cast<std::size_t>(i) * d + c] += share * value(entry, c, i, t);
      }
    }
  }
}

void Boundary::add_surface_force(const Entry& entry, double t, double* force) const {
  const auto d = static_cast<std::size_t>(model_.dimension());
  for (const body::FaceShare& face : entry.faces) {
    double* at = force + static_cast<std::size_t>(face.particle) * d;
    const deck::Point& x = face.center;
    if (entry.load->kind == deck::LoadKind::pressure) {
      const double pressure = (*entry.load->component[0])(x[0], x[1], x[2], t);
      for (std::size_t c = 0; c < d; ++c) at[c] -= face.area[c] * pressure;
      continue;
    }
    for (std::size_t c = 0; c < d; ++c)
      if (entry.load->component[c]) at[c] += face.size * (*entry.load->component[c])(x[0], x[1], x[2], t);
  }
}

}  // namespace perinox::loads
