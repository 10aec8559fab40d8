/// What a run in time carries from one row to the next, on its way to a checkpoint and back.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "perinox/core/clock.hpp"
#include "perinox/core/restored.hpp"
#include "perinox/fracture/broken_bonds.hpp"
#include "perinox/stepping/time_stepper.hpp"

namespace perinox::stepping {

void TimeStepper::save(StateWriter& writer) const {
  writer.integer("stepper/step", step_);
  writer.integer("stepper/estimated", estimated_);
  writer.number("stepper/worst_gain", worst_gain_);
  writer.number("stepper/energy_scale", energy_scale_);
  writer.integer("row/done", row_done_);
  writer.integer("row/count", row_count_);
  writer.number("row/length", length_);
  writer.number("row/end", row_end_);
  writer.number("row/longest", row_longest_);
  const double seconds = row_done_ > 0 ? now() - row_begin_ : 0;
  writer.number("row/seconds", scene_.body().communicator.max(seconds));
  validity_.save(writer);
  motion_->save(writer);
  if (breaking_) fracture::save_broken_bonds(scene_, breaking_->rounds(), writer);
}

// Bonds first: what watches contacts is made of the bonds that are left.
void TimeStepper::restore(StateReader& reader) {
  restored_ = true;
  if (breaking_) {
    fracture::BrokenBonds broken(scene_, reader);
    broken.break_first(broken.count());
    breaking_->resume(broken);
  }
  make_motion();
  motion_->restore(reader);
  validity_.restore(reader);
  energies_ = motion_->energies();
  step_ = restored_count(reader, "stepper/step");
  constexpr long long most = std::numeric_limits<long long>::max();
  estimated_ = restored_integer(reader, "stepper/estimated", 0, most);
  worst_gain_ = reader.number("stepper/worst_gain");
  energy_scale_ = energies_.scale();
  if (reader.has("stepper/energy_scale")) energy_scale_ = restored_number(reader, "stepper/energy_scale", 0);
  row_count_ = restored_integer(reader, "row/count", 0, most);
  row_done_ = restored_integer(reader, "row/done", 0, row_count_);
  length_ = restored_number(reader, "row/length", 0);
  row_end_ = reader.number("row/end");
  row_longest_ = reader.number("row/longest");
  row_seconds_ = reader.number("row/seconds");
  const double t = motion_->t();
  const double left = static_cast<double>(row_count_ - row_done_) * length_;
  reader.refuse_if(row_done_ == 0 || std::abs(t + left - row_end_) <= 1e-6 * row_end_
                       ? std::string()
                       : fmt::format("the {} time steps of {:.4g} that its row has left lead from t = {:g} elsewhere "
                                     "than to t = {:g}",
                                     row_count_ - row_done_, length_, t, row_end_));
  for (row_ = 0; row_ < deck_.steps.count && t >= deck_.steps.end * (row_ + 1) / deck_.steps.count * (1 - 1e-9);)
    ++row_;
}

}  // namespace perinox::stepping
