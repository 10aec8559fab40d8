/// Tests wrong entries of a deck about breaking bonds, motion in time and the way from one to the other. Each ends with
/// one sentence and exit status 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "program.hpp"

namespace perinox::cli {
namespace {

const char* const law = "    damage: {critical_stretch: 0.01}\n";

struct FractureMistake {
  const char* name;
  const char* model;
  const char* material;  ///< keys added to the material
  const char* keys;      ///< added at the end of the deck
  const char* sentence;
};
void PrintTo(const FractureMistake& mistake, std::ostream* out) { *out << mistake.name; }

std::string deck_with(const std::string& model, const std::string& material, const std::string& keys) {
  const std::string yield = "    yield_stress: {tension: 203.1}\n";
  const std::string deck = changed(base_deck, yield, (model == "elastic" ? "" : yield) + material) + keys;
  return changed(deck, "model: elastic-plastic", "model: " + model);
}

const FractureMistake mistakes[] = {
    {"two_laws", "elastic", "    damage: {critical_stretch: 0.01, energy_release_rate: 1}\n", "",
     "deck.yaml:16:38: a damage law has both critical_stretch and energy_release_rate, but these exclude each other; "
     "keep one"},
    {"no_law", "elastic", "    damage: {}\n", "",
     "deck.yaml:16:13: a damage law needs exactly one of critical_stretch, critical_bond_energy, energy_release_rate "
     "or ductile, but has none"},
    {"unknown_law", "elastic", "    damage: {critical_strech: 0.01}\n", "",
     "deck.yaml:16:14: critical_strech is not a key of a damage law; did you mean critical_stretch?"},
    {"law_that_is_a_number", "elastic", "    damage: 0.01\n", "",
     "deck.yaml:16:13: damage must be a map with the keys critical_stretch, critical_bond_energy, energy_release_rate, "
     "ductile and criterion, but '0.01' was found; write {critical_stretch: 0.01}, {critical_bond_energy: 0.01} or "
     "{energy_release_rate: 0.01}"},
    {"stretch_of_zero", "elastic", "    damage: {critical_stretch: 0}\n", "",
     "deck.yaml:16:32: critical_stretch is 0 but must be greater than 0"},
    {"negative_release_rate", "elastic", "    damage: {energy_release_rate: -1}\n", "",
     "deck.yaml:16:35: energy_release_rate is -1 but must be greater than 0"},
    {"negative_bond_energy", "elastic", "    damage: {critical_bond_energy: -1}\n", "",
     "deck.yaml:16:36: critical_bond_energy is -1 but must be greater than 0"},
    {"criterion_without_a_release_rate", "elastic", "    damage: {critical_stretch: 0.01, criterion: stretch}\n", "",
     "deck.yaml:16:49: criterion goes with energy_release_rate only; remove it"},
    {"unknown_criterion", "elastic", "    damage: {energy_release_rate: 1, criterion: energy}\n", "",
     "deck.yaml:16:49: criterion cannot be 'energy'; did you mean bond-energy?"},
    {"ductile_without_a_strain", "elastic-plastic", "    damage: {ductile: {c: 1}}\n", "",
     "deck.yaml:17:23: materials.steel.damage.ductile needs the key d0 (a number): Failure strain at zero "
     "triaxiality."},
    {"ductile_of_a_negative_slope", "elastic-plastic", "    damage: {ductile: {d0: 0.1, c: -1}}\n", "",
     "deck.yaml:17:36: c is -1 but must be at least 0"},
    {"ductile_law_of_an_elastic_material", "elastic", "    damage: {ductile: {d0: 0.1}}\n", "",
     "deck.yaml:16:13: the model elastic has no plastic strain for a ductile law to look at; take a plastic model, or "
     "another law"},
    {"bond_energy_of_a_material_that_flows", "elastic-plastic", "    damage: {critical_bond_energy: 1}\n", "",
     "deck.yaml:17:13: the bonds of steel flow, so their energy says little about when they break; take "
     "critical_stretch or ductile"},
    {"bond_energy_criterion_of_a_material_that_flows", "elastic-plastic",
     "    damage: {energy_release_rate: 1, criterion: bond-energy}\n", "",
     "deck.yaml:17:13: the bonds of steel flow, so their energy says little about when they break; take criterion: "
     "stretch"},
    {"density_of_zero", "elastic", "    density: 0\n", "", "deck.yaml:16:14: density is 0 but must be greater than 0"},
    {"unknown_unbreakable_set", "elastic", law, "fracture: {unbreakable: [foot, haed]}\n",
     "deck.yaml:31:32: haed is not the name of a set or body; did you mean head?"},
    {"unbreakable_set_twice", "elastic", law, "fracture: {unbreakable: [foot, foot]}\n",
     "deck.yaml:31:32: foot is named twice in unbreakable; remove one"},
    {"unbreakable_not_a_list", "elastic", law, "fracture: {unbreakable: foot}\n",
     "deck.yaml:31:25: unbreakable must be a list, but 'foot' was found; write [foot]"},
    {"pass_share_above_one", "elastic", law, "fracture: {pass_share: 1.5}\n",
     "deck.yaml:31:24: pass_share is 1.5 but must be greater than 0 and at most 1"},
    {"no_passes", "elastic", law, "fracture: {max_passes: 0}\n",
     "deck.yaml:31:24: max_passes is 0 but must be at least 1 and at most 1000000000"},
    {"unknown_key_of_fracture", "elastic", law, "fracture: {passes: 3}\n",
     "deck.yaml:31:12: passes is not a key of fracture; did you mean max_passes?"},
    {"unknown_fallback", "elastic", law, "fallback: dynamic\n",
     "deck.yaml:31:11: fallback cannot be 'dynamic'; it can be automatic, explicit or none"},
    {"fallback_without_a_density", "elastic", law, "fallback: explicit\n",
     "deck.yaml:13:5: the material steel needs the key density: fallback: explicit goes on in time"},
    {"unknown_key_of_hand_over", "elastic", law, "hand_over: {share: 0.1}\n",
     "deck.yaml:31:13: share is not a key of hand_over; its keys are broken_share, overload, kinetic_share, "
     "quiet_time, longest_time, damping and rate"},
    {"overload_below_one", "elastic", law, "hand_over: {overload: 0.5}\n",
     "deck.yaml:31:23: overload is 0.5 but must be at least 1"},
    {"broken_share_above_one", "elastic", law, "hand_over: {broken_share: 2}\n",
     "deck.yaml:31:27: broken_share is 2 but must be greater than 0 and at most 1"},
    {"kinetic_share_of_zero", "elastic", law, "hand_over: {kinetic_share: 0}\n",
     "deck.yaml:31:28: kinetic_share is 0 but must be greater than 0 and at most 1"},
    {"negative_quiet_time", "elastic", law, "hand_over: {quiet_time: -1}\n",
     "deck.yaml:31:25: quiet_time is -1 but must be greater than 0"},
    {"negative_rate", "elastic", law, "hand_over: {rate: -1}\n", "deck.yaml:31:19: rate is -1 but must be at least 0"},
    {"negative_damping", "elastic", law, "hand_over: {damping: -1}\n",
     "deck.yaml:31:22: damping is -1 but must be at least 0"},
    {"longest_time_that_is_a_word", "elastic", law, "hand_over: {longest_time: long}\n",
     "deck.yaml:31:27: longest_time must be a number, but 'long' was found"},
    {"unknown_dynamics", "elastic", "    density: 1.0e-9\n", "dynamics: implicit\n",
     "deck.yaml:31:11: dynamics cannot be 'implicit'; did you mean explicit?"},
    {"time_steps_without_end", "elastic", "    density: 7.85e-9\n",
     "dynamics: explicit\nexplicit: {time_step: 1e-300}\n",
     "deck.yaml:32:11: t goes from 0 to 1 in 1e+300 time steps of 1e-300, more than 1e+15; take a longer time_step or "
     "a "
     "smaller steps.end, and look at the units of moduli and densities"},
    {"dynamics_without_a_density", "elastic", "", "dynamics: explicit\n",
     "deck.yaml:13:5: the material steel needs the key density: dynamics is explicit"},
    {"initial_velocity_at_rest", "elastic", "    density: 1.0e-9\n",
     "initial_velocity: [{set: head, velocity: {z: 1}}]\n",
     "deck.yaml:31:20: an initial velocity needs dynamics: explicit; remove it, or ask for it"},
    {"initial_velocity_of_an_unknown_set", "elastic", "    density: 1.0e-9\n",
     "dynamics: explicit\ninitial_velocity: [{set: haed, velocity: {z: 1}}]\n",
     "deck.yaml:32:26: haed is not the name of a set or body; did you mean head?"},
    {"initial_velocity_of_the_time", "elastic", "    density: 1.0e-9\n",
     "dynamics: explicit\ninitial_velocity: [{set: head, velocity: {z: \"t\"}}]\n",
     "deck.yaml:32:46: an initial velocity holds at t = 0 only, so its formula cannot use t; remove it"},
    {"initial_velocity_without_a_component", "elastic", "    density: 1.0e-9\n",
     "dynamics: explicit\ninitial_velocity: [{set: head, velocity: {}}]\n",
     "deck.yaml:32:42: initial_velocity.0.velocity is empty; it needs x, y or z"},
    {"safety_above_one", "elastic", "    density: 1.0e-9\n", "dynamics: explicit\nexplicit: {safety: 1.1}\n",
     "deck.yaml:32:20: safety is 1.1 but must be greater than 0 and at most 1"},
    {"contact_distance_of_zero", "elastic", "    density: 1.0e-9\n",
     "dynamics: explicit\nexplicit: {contact: {distance: 0}}\n",
     "deck.yaml:32:32: distance is 0 but must be greater than 0"},
};

class MalformedFracture : public ::testing::TestWithParam<FractureMistake> {};

TEST_P(MalformedFracture, IsRefusedInOneSentence) {
  const FractureMistake& mistake = GetParam();
  const Folder folder;
  folder.write("deck.yaml", deck_with(mistake.model, mistake.material, mistake.keys));
  const Outcome outcome = folder.perinox({"check", "deck.yaml"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error, std::string(mistake.sentence) + "\n");
  EXPECT_EQ(outcome.out, "");
}

INSTANTIATE_TEST_SUITE_P(Cli, MalformedFracture, ::testing::ValuesIn(mistakes),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(MalformedFracture, ALawAlongTheArcIsRefused) {
  const Folder folder;
  folder.write("deck.yaml", changed(deck_with("elastic", law, ""), "count: 2}", "count: 2, control: arc-length}"));
  const Outcome outcome = folder.perinox({"check", "deck.yaml"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error,
            "deck.yaml:16:13: arc-length control follows a body whose bonds hold: between two passes of bond breaking "
            "there is no path to follow; remove damage, or use steps.control: load\n");
}

/// The same keys pass when they are mended, so what is refused above is the mistake.
TEST(MalformedFracture, TheMendedDecksPass) {
  const Folder folder;
  for (const std::string& deck :
       {deck_with("elastic", law, "fracture: {unbreakable: [foot, head], pass_share: 1, max_passes: 1}\n"),
        deck_with("elastic-plastic", "    damage: {ductile: {d0: 0.1, c: 0}}\n", "fallback: none\n"),
        deck_with("elastic", "    density: 1.0e-9\n    damage: {energy_release_rate: 1, criterion: bond-energy}\n",
                  "fallback: explicit\nhand_over: {overload: 1, broken_share: 1, rate: 0, damping: 0}\n"),
        deck_with(
            "elastic", "    density: 1.0e-9\n",
            "dynamics: explicit\nexplicit: {safety: 1, contact: {}}\ninitial_velocity: [{set: head, velocity: {x: "
            "1}}]\n")}) {
    folder.write("deck.yaml", deck);
    const Outcome outcome = folder.perinox({"check", "deck.yaml"});
    EXPECT_EQ(outcome.status, 0) << outcome.error << deck;
  }
}

}  // namespace
}  // namespace perinox::cli
