#pragma once
#include <memory>
#include <string>

#include "perinox/deck/location.hpp"

namespace perinox::deck {

/// A formula of x, y, z (reference position) and t (load parameter), evaluated by muParser. It is parsed, and evaluated
/// once at the origin, when it is built, so that a misspelt name is an InputError at the deck's line before anything
/// runs. Copies share the compiled formula. One Expression may be used by one thread at a time.
class Expression {
 public:
  /// The constant zero.
  Expression();
  /// A constant.
  explicit Expression(double value);
  /// Throws InputError (`file:line:column: ...`) if the formula cannot be read.
  Expression(std::string formula, const Location& where);

  double operator()(double x, double y, double z, double t) const;
  /// Takes the formula as the condition of a set, which holds where the value is not zero.
  bool holds(double x, double y, double z) const { return (*this)(x, y, z, 0.0) != 0.0; }
  const std::string& text() const { return text_; }
  bool uses_time() const;
  bool uses_position() const;  ///< true if the formula uses x, y or z

 private:
  struct Compiled;
  std::string text_;
  double constant_ = 0;  ///< the value where there is no formula
  std::shared_ptr<Compiled> compiled_;
};

}  // namespace perinox::deck
