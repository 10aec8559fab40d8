#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "perinox/core/types.hpp"

namespace perinox::mechanics {

class Scene;

/// Plastic extension e_p of the committed state, bond by bond and end by end, in the order in which the sweeps read it:
/// a chunk for every block of lattice cells (every near end of pairs) where something has flowed, nothing elsewhere.
class PlasticExtension {
 public:
  /// One pointer a block or near end, null where nothing has flowed; null as a whole where nothing has anywhere.
  double* const* chunks() const { return chunks_.empty() ? nullptr : chunks_.data(); }
  /// Makes chunk k of `count` (of all `blocks`), zero, if it is not there yet.
  void require(std::size_t k, std::size_t blocks, std::size_t count);
  std::size_t bytes() const { return bytes_; }

  /// 1 for every particle whose family has flowed: e_p is zero at the others' ends. [owned], empty where none has.
  const std::vector<char>& flowed() const { return flowed_; }
  /// Notes the particles that flow in a step. flow: [owned].
  void mark(const std::vector<double>& flow);
  /// e_p at particle i's own end of its bond to j, which has to be there; i is owned.
  double of_bond(const Scene& scene, LocalIndex i, LocalIndex j) const;

  /// e_p of every bond of scene.bonds(), in its order. For the sparse assembly and for checks.
  std::vector<double> per_bond(const Scene& scene) const;

 private:
  struct Free {
    void operator()(double* p) const;
  };
  std::vector<double*> chunks_;
  std::vector<std::unique_ptr<double[], Free>> owned_;
  std::vector<char> flowed_;
  std::size_t bytes_ = 0;
};

}  // namespace perinox::mechanics
