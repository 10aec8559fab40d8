#pragma once
#include <string>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"
#include "perinox/medium/displacement.hpp"

namespace perinox::equilibrium {

/// A point of the path of equilibria, or a step along it.
struct PathPoint {
  medium::Displacement displacement;  ///< [owned * dimension]
  double t = 0;                       ///< load parameter
};

/// Length of a step along the path: that of its displacements, du.du/length^2 over all ranks. t does not count: its
/// share was measured and brought nothing (docs/arc_length.md). Collective.
struct PathNorm {
  const Communicator* ranks = nullptr;
  double length = 1;  ///< 2-norm of displacement that counts as one

  double product(const PathPoint& a, const PathPoint& b) const;
  double of(const PathPoint& a) const;
};

/// The equation that a step along the path fulfils besides equilibrium: value(u, t) = 0. Dimensionless. Collective.
class PathConstraint {
 public:
  virtual ~PathConstraint() = default;
  virtual double value(const PathPoint& at) const = 0;
  /// Its derivative along `direction`.
  virtual double slope(const PathPoint& at, const PathPoint& direction) const = 0;
  /// |value| that is small enough.
  virtual double tolerance() const = 0;
};

/// The step from `origin` has the length `arc`.
class FixedArc : public PathConstraint {
 public:
  FixedArc(const PathNorm& norm, const PathPoint& origin, double arc) : norm_(norm), origin_(origin), arc_(arc) {}
  double value(const PathPoint& at) const override;
  double slope(const PathPoint& at, const PathPoint& direction) const override;
  /// The arc is a choice; nobody needs it exactly.
  double tolerance() const override { return 1e-2; }

 private:
  PathPoint step(const PathPoint& at) const;
  const PathNorm& norm_;
  const PathPoint& origin_;
  double arc_;
};

/// t is given. Newton keeps it exactly from the first full step on.
class FixedLoad : public PathConstraint {
 public:
  FixedLoad(double t, double load) : t_(t), load_(load) {}
  double value(const PathPoint& at) const override { return (at.t - t_) / load_; }
  double slope(const PathPoint&, const PathPoint& direction) const override { return direction.t / load_; }
  double tolerance() const override { return 1e-12; }

 private:
  double t_, load_;
};

/// The mean displacement of a set, by volume, is given.
class FixedMean : public PathConstraint {
 public:
  /// set: this rank's particles; volume: of all of them. Both are kept by reference. target: length, not zero.
  FixedMean(const Communicator& ranks, const std::vector<LocalIndex>& set, const std::vector<double>& volume,
            int dimension, int component, double target);
  /// Mean displacement of the set, length.
  double mean(const std::vector<double>& displacement) const;
  double value(const PathPoint& at) const override { return mean(at.displacement.values()) / target_ - 1; }
  double slope(const PathPoint&, const PathPoint& direction) const override {
    return mean(direction.displacement.values()) / target_;
  }
  double tolerance() const override { return 1e-10; }

 private:
  const Communicator& ranks_;
  const std::vector<LocalIndex>& set_;
  const std::vector<double>& volume_;
  std::size_t dimension_, component_;
  double target_;
  double whole_;  ///< volume of the set, all ranks
};

}  // namespace perinox::equilibrium
