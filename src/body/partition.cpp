#include "partition.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Zoltan2_BasicVectorAdapter.hpp>
#include <Zoltan2_PartitioningProblem.hpp>
#include <Zoltan2_PartitioningSolution.hpp>
#include <string>

namespace perinox::body {

namespace {

using Types = Zoltan2::BasicUserTypes<double, int, GlobalId>;
using Adapter = Zoltan2::BasicVectorAdapter<Types>;

/// If there are no more particles than parts, each particle gets a part of its own and the parts beyond stay empty.
std::vector<int> one_each(const std::vector<Particle>& particles) {
  std::vector<int> destination;
  for (const Particle& particle : particles) destination.push_back(static_cast<int>(particle.id));
  return destination;
}

const char* name_of(PartitionMethod method) {
  return method == PartitionMethod::rcb ? "rcb" : method == PartitionMethod::multijagged ? "multijagged" : "hsfc";
}

}  // namespace

std::vector<int> partition(const std::vector<Particle>& particles, const std::vector<double>& weights, int dimension,
                           const Communicator& communicator) {
  return partition(particles, weights, dimension, communicator, communicator.size(), PartitionMethod::rcb);
}

std::vector<int> partition(const std::vector<Particle>& particles, const std::vector<double>& weights, int dimension,
                           const Communicator& communicator, int parts, PartitionMethod method) {
  const std::size_t count = particles.size();
  if (parts == 1) return std::vector<int>(count, 0);
  if (communicator.sum(static_cast<long long>(count)) <= parts) return one_each(particles);
  const bool weighted = communicator.any(!weights.empty());

  // Zoltan2 needs valid addresses even where a rank has nothing to show. One unused entry keeps them valid.
  std::vector<GlobalId> ids(count + 1);
  std::vector<std::vector<double>> columns(static_cast<std::size_t>(dimension), std::vector<double>(count + 1));
  for (std::size_t i = 0; i < count; ++i) {
    ids[i] = particles[i].id;
    for (std::size_t axis = 0; axis < columns.size(); ++axis) columns[axis][i] = particles[i].position[axis];
  }
  std::vector<const double*> column_starts;
  // A cube is cut across its last axis, so that what is left keeps whole rows along x, in the order of the particles.
  for (auto column = columns.rbegin(); column != columns.rend(); ++column) column_starts.push_back(column->data());
  std::vector<double> padded = weights;
  padded.resize(count + 1);
  std::vector<const double*> weight_starts;
  if (weighted) weight_starts.push_back(padded.data());
  std::vector<int> coordinate_strides, weight_strides;  // empty: each column is contiguous
  Adapter adapter(static_cast<int>(count), ids.data(), column_starts, coordinate_strides, weight_starts,
                  weight_strides);

  Teuchos::ParameterList parameters;
  parameters.set("algorithm", std::string(name_of(method)));
  parameters.set("num_global_parts", parts);
  parameters.set("imbalance_tolerance", 1.01);
  parameters.sublist("zoltan_parameters").set("DEBUG_LEVEL", "0");  // or it prints all its settings
  Zoltan2::PartitioningProblem<Adapter> problem(&adapter, &parameters, communicator.mpi());
  problem.solve();

  std::vector<int> destination(count);
  const auto* part_of = problem.getSolution().getPartListView();
  for (std::size_t i = 0; i < count; ++i) destination[i] = static_cast<int>(part_of[i]);
  return destination;
}

}  // namespace perinox::body
