#pragma once
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include "perinox/body/body.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/output/results_file.hpp"
#include "perinox/solve/record.hpp"

namespace perinox::output {

/// Writes everything a run leaves in its directory: results.h5 and results.xdmf, history.csv, convergence.csv,
/// deck.resolved.yaml; and prints the Newton table and progress on the terminal unless quiet.
class RunWriter : public solve::Observer {
 public:
  /// Creates the directory (refuses with InputError one that holds results already, unless `overwrite`). Collective.
  RunWriter(const deck::Deck& deck, const body::Body& body, std::string directory, bool quiet, bool overwrite);
  ~RunWriter() override;

  void newton_iteration(const solve::NewtonIteration& row) override;
  void step_rejected(double t_from, double t_to, const std::string& reason) override;
  void step_committed(const solve::StepRecord& record) override;

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace perinox::output
