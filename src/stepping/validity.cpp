#include "perinox/stepping/validity.hpp"

#include <fmt/format.h>

#include "perinox/core/restored.hpp"

namespace perinox::stepping {

Validity::Validity(const deck::Deck& deck, const mechanics::Scene& scene)
    : scene_(scene), flows_(flows_finitely(scene)) {
  if (!deck.may_overlap()) return;
  always_ = (!deck.bond_bodies && deck.body.size() > 1) || scene.body().communicator.sum(scene.families().cut) > 0;
  faces_ = std::make_unique<motion::Interpenetration>(scene);
  overlap_ = 0;
}

bool Validity::faces_are_open() const {
  return always_ || scene_.body().communicator.sum(scene_.families().broken) > 0;
}

void Validity::look(const mechanics::Committed& state, int step, const std::vector<char>& loose, Observer& observer) {
  if (faces_ && faces_are_open()) {
    motion::Overlap found = faces_->measure(state.displacement(), loose);
    found.t = state.t();
    found.step = step;
    overlap_ = found.depth;
    if (found.depth > 0) observer.note(fmt::format("warning: {}", describe(found)));
    if (found.depth > deepest_.depth) deepest_ = found;
  }
  if (!flows_) return;
  BondStretch found = largest_plastic_stretch(scene_, state.displacement());
  found.t = state.t();
  found.step = step;
  if (found.stretch > most_plastic_stretch && longest_.stretch <= most_plastic_stretch)
    observer.note(fmt::format("warning: in step {}, t = {:.6g}, {}", step, found.t, describe(found)));
  if (found.stretch > longest_.stretch) longest_ = found;
}

std::vector<std::string> Validity::at_end() const {
  std::vector<std::string> sentences;
  if (deepest_.depth > 0)
    sentences.push_back(
        fmt::format("in step {}, t = {:.6g}, {}: nothing keeps them apart in a run without contact, and what they "
                    "would carry is missing in forces and energies (docs/fracture.md)",
                    deepest_.step, deepest_.t, describe(deepest_)));
  if (longest_.stretch > most_plastic_stretch)
    sentences.push_back(fmt::format("in step {}, t = {:.6g}, {} (docs/theory.md, section 3)", longest_.step, longest_.t,
                                    describe(longest_)));
  return sentences;
}

void Validity::save(StateWriter& writer) const {
  const auto place = [&](const std::string& name, double size, double t, int step, const deck::Point& at) {
    writer.number(name + "/size", size);
    writer.number(name + "/t", t);
    writer.integer(name + "/step", step);
    for (std::size_t c = 0; c < 3; ++c) writer.number(name + "/" + "xyz"[c], at[c]);
  };
  if (faces_) {
    place("overlap", deepest_.depth, deepest_.t, deepest_.step, deepest_.place);
    writer.number("overlap/spacings", deepest_.spacings);
  }
  if (flows_) place("stretch", longest_.stretch, longest_.t, longest_.step, longest_.place);
}

// A checkpoint of a version that did not look has nothing to tell.
void Validity::restore(StateReader& reader) {
  const auto place = [&](const std::string& name, double& size, double& t, int& step, deck::Point& at) {
    size = restored_number(reader, name + "/size", 0);
    t = reader.number(name + "/t");
    step = restored_count(reader, name + "/step");
    for (std::size_t c = 0; c < 3; ++c) at[c] = reader.number(name + "/" + "xyz"[c]);
  };
  if (faces_ && reader.has("overlap/size")) {
    place("overlap", deepest_.depth, deepest_.t, deepest_.step, deepest_.place);
    deepest_.spacings = reader.number("overlap/spacings");
  }
  if (flows_ && reader.has("stretch/size"))
    place("stretch", longest_.stretch, longest_.t, longest_.step, longest_.place);
}

}  // namespace perinox::stepping
