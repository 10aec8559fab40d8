#pragma once
/// The parts of a run hand over what they need to know to go on later, and take it back. They do so by name, without
/// knowing the file. Every member is collective, and every rank calls them in the same order.
#include <functional>
#include <string>
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox {

/// Writes a state. What is written does not depend on the ranks: values of particles go by the particles' ids.
class StateWriter {
 public:
  virtual ~StateWriter() = default;
  /// Writes one number, the same on every rank. `name` is a path of words such as "stepper/t".
  virtual void number(const std::string& name, double value) = 0;
  virtual void integer(const std::string& name, long long value) = 0;
  virtual void text(const std::string& name, const std::string& value) = 0;
  /// Writes values of the owned particles. values: [owned * components]
  virtual void particles(const std::string& name, const double* values, int components) = 0;

  /// A function that appends the lists of these owned particles, one after the other, to `values`.
  using Source = std::function<void(const std::vector<LocalIndex>& particles, std::vector<double>& values)>;
  /// Writes a list of numbers for every particle, each of its own length. Examples are history variables, one number a
  /// bond in ascending id of the neighbour, and ids. count: [owned] lengths. The lists are asked for in portions, each
  /// list that is not empty once, so that large ones need no second copy. Whole numbers are kept exactly up to 2^53.
  virtual void lists(const std::string& name, const std::vector<int>& count, const Source& source) = 0;
};

/// Reads a state. Members throw InputError on every rank where a name is missing or a table does not fit this body.
class StateReader {
 public:
  virtual ~StateReader() = default;
  virtual bool has(const std::string& name) const = 0;
  virtual double number(const std::string& name) const = 0;
  virtual long long integer(const std::string& name) const = 0;
  virtual std::string text(const std::string& name) const = 0;
  /// Values of the owned particles. [owned * components]
  virtual std::vector<double> particles(const std::string& name, int components) const = 0;

  /// A function that takes the lists of these owned particles, one after the other.
  using Sink = std::function<void(const std::vector<LocalIndex>& particles, const std::vector<double>& values)>;
  /// Lengths of the lists. [owned]
  virtual std::vector<int> list_counts(const std::string& name) const = 0;
  /// Hands out every list that is not empty, in portions.
  virtual void lists(const std::string& name, const Sink& sink) const = 0;
  /// Refuses the state with InputError on every rank if any rank passes a sentence that is not empty.
  virtual void refuse_if(const std::string& sentence) const = 0;
};

}  // namespace perinox
