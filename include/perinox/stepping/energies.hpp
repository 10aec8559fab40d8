#pragma once

namespace perinox::motion {
struct MotionEnergies;
}

namespace perinox::stepping {

/// The ledger of a run: work and energy since t = 0, over all ranks.
struct Energies {
  double stored = 0;  ///< in what is held: not in pieces taken out as loose
  double dissipated = 0;
  /// Of the reactions and the external forces, trapezoidal over each step. Where something flows in a load step it is
  /// the work of the path that return mapping takes (docs/theory.md, section 4).
  double external_work = 0;
  double released = 0;  ///< stored energy that went with breaking bonds, the deformation held
  double relaxed = 0;   ///< lost on the way down to the next equilibrium, or stored in what came loose
  double damped = 0;    ///< while the run went on in time, the kinetic energy left at its end included
  /// The largest of stored, dissipated and external work at any step so far, and at least that of energy_scale.hpp.
  double scale = 0;

  /// External work that is nowhere, over the scale.
  double unaccounted() const;
  /// What a jump to another equilibrium has lost since `before`: work and stored energy that are nowhere now. The model
  /// has neither kinetic energy nor damping there, so it is gone. Whoever jumps adds it to `relaxed` or `damped`.
  double lost_since(const Energies& before) const;
  /// What a phase in time has done; its kinetic energy at the end and that of contacts count as damped.
  void add_phase(const motion::MotionEnergies& phase);
  /// Raises the scale. least: energy below which nothing is known.
  void raise_scale(double least);
};

}  // namespace perinox::stepping
