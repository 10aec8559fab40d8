/// A committed state on its way to a file and back.
#include <fmt/format.h>

#include <algorithm>

#include "perinox/core/restored.hpp"
#include "perinox/mechanics/evaluation.hpp"
#include "plastic_lists.hpp"

namespace perinox::mechanics {

namespace {

constexpr const char* elastic_name = "state/broken_elastic";
/// Numbers of a bonds::BrokenElastic.
constexpr int elastic_size = 7;

std::vector<int> lengths(const std::vector<std::int64_t>& begin) {
  std::vector<int> count;
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) count.push_back(static_cast<int>(begin[i + 1] - begin[i]));
  return count;
}

StateWriter::Source slices(const std::vector<std::int64_t>& begin, const std::vector<double>& all) {
  return [&](const std::vector<LocalIndex>& particles, std::vector<double>& values) {
    for (const LocalIndex i : particles) values.insert(values.end(), all.data() + begin[i], all.data() + begin[i + 1]);
  };
}

void take_slices(const StateReader& reader, const std::string& name, const std::vector<std::int64_t>& begin,
                 std::vector<double>& all) {
  reader.refuse_if(
      reader.list_counts(name) == lengths(begin)
          ? std::string()
          : fmt::format("its {} has another number of variables a particle than this deck's materials", name));
  reader.lists(name, [&](const std::vector<LocalIndex>& particles, const std::vector<double>& values) {
    auto next = values.begin();
    for (const LocalIndex i : particles) {
      const std::int64_t count = begin[i + 1] - begin[i];
      std::copy(next, next + count, all.begin() + begin[i]);
      next += count;
    }
  });
}

}  // namespace

void Committed::save(const Scene& scene, StateWriter& writer) const {
  writer.number("state/t", t_);
  writer.particles("state/displacement", displacement_.data(), scene.dimension());
  writer.particles("state/mean", mean_.data(), 1);
  writer.lists("state/point_history", lengths(scene.point_history()), slices(scene.point_history(), point_history_));
  if (!scene.from_sums())
    writer.lists("state/bond_history", lengths(scene.bond_history()), slices(scene.bond_history(), bond_history_));
  if (!scene.plastic()) return;
  std::vector<double> elastic(elastic_size * mean_.size(), 0.0);
  for (std::size_t i = 0; i < broken_elastic_.size(); ++i) {
    std::copy(broken_elastic_[i].fit.begin(), broken_elastic_[i].fit.end(), &elastic[elastic_size * i]);
    elastic[elastic_size * i + elastic_size - 1] = broken_elastic_[i].square;
  }
  if (scene.body().communicator.any(!broken_elastic_.empty()))
    writer.particles(elastic_name, elastic.data(), elastic_size);
  const std::vector<char>& flowed = plastic_->flowed();
  std::vector<int> count(static_cast<std::size_t>(scene.owned()), 0);
  for (std::size_t i = 0; i < flowed.size(); ++i)
    if (flowed[i]) count[i] = scene.families().size[i];
  std::unique_ptr<PlasticLists> lists;  // made only for a writer that asks for values
  writer.lists("state/plastic_extension", count,
               [&](const std::vector<LocalIndex>& particles, std::vector<double>& values) {
                 if (particles.empty()) return;
                 if (!lists) lists = std::make_unique<PlasticLists>(scene);
                 lists->read(*plastic_, particles, values);
               });
}

void Committed::restore(Evaluation& evaluation, StateReader& reader) {
  const Scene& scene = evaluation.scene();
  const int d = scene.dimension();
  t_ = restored_number(reader, "state/t", 0);
  const std::vector<double> displacement = reader.particles("state/displacement", d);
  std::copy(displacement.begin(), displacement.end(), displacement_.begin());
  scene.body().halo.update_ghosts(displacement_.data(), d);
  mean_ = reader.particles("state/mean", 1);
  take_slices(reader, "state/point_history", scene.point_history(), point_history_);
  if (!scene.from_sums()) take_slices(reader, "state/bond_history", scene.bond_history(), bond_history_);
  version_ = medium::new_version();
  plastic_ = std::make_shared<PlasticExtension>();
  broken_elastic_.clear();
  if (!scene.plastic()) return;
  if (reader.has(elastic_name)) {
    const std::vector<double> elastic = reader.particles(elastic_name, elastic_size);
    broken_elastic_.resize(mean_.size());
    for (std::size_t i = 0; i < broken_elastic_.size(); ++i) {
      std::copy_n(&elastic[elastic_size * i], elastic_size - 1, broken_elastic_[i].fit.begin());
      broken_elastic_[i].square = elastic[elastic_size * i + elastic_size - 1];
    }
  }

  const std::vector<int> count = reader.list_counts("state/plastic_extension");
  std::string sentence;
  std::vector<double> flowed(count.size(), 0.0);
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (count[i] == 0) continue;
    flowed[i] = 1;
    if (count[i] != scene.families().size[i])
      sentence = fmt::format("it holds the plastic extension of {} bonds of particle {}, which has {}", count[i],
                             scene.body().id[i], scene.families().size[i]);
  }
  reader.refuse_if(sentence);
  // The sweep that lets plastic extension grow makes the same arrays for the same particles as it did in the run that
  // was saved; what it writes there is replaced.
  if (std::any_of(flowed.begin(), flowed.end(), [](double flow) { return flow != 0; })) {
    evaluation.loops().advance(displacement_.data(), mean_.data(), flowed.data(), *plastic_);
    plastic_->mark(flowed);
  }
  PlasticLists lists(scene);
  reader.lists("state/plastic_extension",
               [&](const std::vector<LocalIndex>& particles, const std::vector<double>& values) {
                 lists.write(*plastic_, particles, values);
               });
}

}  // namespace perinox::mechanics
