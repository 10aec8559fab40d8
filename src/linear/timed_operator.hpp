#pragma once
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>
#include <utility>

#include "perinox/core/profile.hpp"
#include "perinox/core/tpetra.hpp"

namespace perinox::linear {

/// Another operator, whose applications count in a section of the profile: for those that are Trilinos' own code.
class TimedOperator : public tpetra::Operator {
 public:
  /// profile is kept by reference.
  TimedOperator(Teuchos::RCP<const tpetra::Operator> inner, Profile& profile, Section section)
      : inner_(std::move(inner)), profile_(profile), section_(section) {}

  Teuchos::RCP<const tpetra::Map> getDomainMap() const override { return inner_->getDomainMap(); }
  Teuchos::RCP<const tpetra::Map> getRangeMap() const override { return inner_->getRangeMap(); }
  bool hasTransposeApply() const override { return inner_->hasTransposeApply(); }
  void apply(const tpetra::MultiVector& x, tpetra::MultiVector& y, Teuchos::ETransp mode, double alpha,
             double beta) const override {
    const Profile::Scope timed(profile_, section_);
    inner_->apply(x, y, mode, alpha, beta);
  }

 private:
  Teuchos::RCP<const tpetra::Operator> inner_;
  Profile& profile_;
  Section section_;
};

}  // namespace perinox::linear
