#pragma once
#include <string>
#include <vector>

namespace perinox::deck {

/// All columns that history.csv has by itself in some run. A history entry of such a name would be a second column
/// under one header, or it would become one when the deck is given a damage law.
inline const std::vector<std::string> history_columns{
    "step",
    "t",
    "stored_energy",
    "dissipated_energy",
    "external_work",
    "newton_iterations",
    "linear_iterations",
    "seconds",
    "products",
    "seconds_product",
    "seconds_preconditioner",
    "seconds_halo",
    "seconds_assembly",
    "seconds_output",
    "seconds_force",
    "seconds_linearise",
    "passes",
    "broken_bonds",
    "released_energy",
    "relaxed_energy",
    "fragments",
    "single_particles",
    "time",
    "time_steps",
    "kinetic_energy",
    "damped_energy",
    "contact_energy",
    "phases",
    "cause",
    "phase_time",
    "phase_energy",
    "overlap",
};

}  // namespace perinox::deck
