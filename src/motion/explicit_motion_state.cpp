/// A motion on its way to a checkpoint and back.
#include <algorithm>
#include <limits>

#include "perinox/core/restored.hpp"
#include "perinox/motion/explicit_motion.hpp"

namespace perinox::motion {

// Forces and accelerations could be found anew from the rest, but to rounding only. What strains are measured from is
// the committed state's, which is that of the last time step only where materials have a history or somebody asked.
void ExplicitMotion::save(StateWriter& writer) const {
  const int d = scene_.dimension();
  const Communicator& ranks = scene_.body().communicator;
  writer.number("motion/start", start_);
  writer.number("motion/since", since_);
  writer.number("motion/rate", settings_.rate);
  writer.number("motion/time", time_);
  writer.number("motion/last_step", last_step_);
  writer.integer("motion/time_steps", time_steps_);
  writer.number("motion/eigenvalue", eigenvalue());
  std::vector<double> sums{work_, damped_, dissipated_, trial_.stored, contact_energy_};
  ranks.sum(sums);
  writer.number("motion/external_work", before_.work + sums[0]);
  writer.number("motion/damped", before_.damped + sums[1]);
  writer.number("motion/dissipated", before_.dissipated + sums[2]);
  writer.number("motion/stored", sums[3]);
  writer.number("motion/contact_energy", sums[4]);
  writer.number("motion/released", released_);
  writer.number("motion/at_start", at_start_);
  writer.particles("motion/velocity", velocity_.data(), d);
  writer.particles("motion/acceleration", acceleration_.data(), d);
  writer.particles("motion/force", force_.data(), d);
  if (!up_to_date_) {
    writer.particles("motion/displacement", trial_.displacement.data(), d);
    writer.particles("motion/mean", trial_.mean.data(), 1);
  }
  if (contact_) {
    writer.particles("motion/contact_force", contact_force_.data(), d);
    contact_->save(writer);
  }
  committed_.save(scene_, writer);
}

void ExplicitMotion::restore(StateReader& reader) {
  const int d = scene_.dimension();
  const bool first = scene_.body().communicator.is_root();
  committed_.restore(*evaluation_, reader);
  trial_.displacement = committed_.displacement();
  up_to_date_ = !reader.has("motion/displacement");
  if (!up_to_date_) {
    const std::vector<double> displacement = reader.particles("motion/displacement", d);
    std::copy(displacement.begin(), displacement.end(), trial_.displacement.begin());
    scene_.body().halo.update_ghosts(trial_.displacement.data(), d);
    trial_.mean = reader.particles("motion/mean", 1);
  }
  start_ = reader.number("motion/start");
  since_ = reader.number("motion/since");
  settings_.rate = reader.number("motion/rate");
  time_ = restored_number(reader, "motion/time", 0);
  last_step_ = restored_number(reader, "motion/last_step", 0);
  time_steps_ = restored_integer(reader, "motion/time_steps", 0, std::numeric_limits<long long>::max());
  trial_.t = t();
  const double eigenvalue = reader.number("motion/eigenvalue");
  lambda_.reset();
  if (eigenvalue > 0) lambda_ = eigenvalue;
  before_ = {reader.number("motion/external_work"), reader.number("motion/damped"), reader.number("motion/dissipated")};
  work_ = damped_ = dissipated_ = 0;
  const double stored = reader.number("motion/stored"), in_contacts = reader.number("motion/contact_energy");
  trial_.stored = first ? stored : 0;  // shares of the ranks, whose sum alone matters
  contact_energy_ = first ? in_contacts : 0;
  released_ = reader.number("motion/released");
  at_start_ = reader.number("motion/at_start");
  velocity_ = reader.particles("motion/velocity", d);
  acceleration_ = reader.particles("motion/acceleration", d);
  force_ = reader.particles("motion/force", d);
  if (contact_) {
    contact_force_ = reader.particles("motion/contact_force", d);
    contact_->restore(reader);
  }
  if (boundary_.has_forces()) boundary_.external_force(t(), loads_.data());
  for (std::size_t u = 0; u < external_.size(); ++u) external_[u] = loads_[u] + (contact_ ? contact_force_[u] : 0);
  moving_ = true;
}

}  // namespace perinox::motion
