#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "perinox/mechanics/plastic_extension.hpp"
#include "perinox/mechanics/scene.hpp"
#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

/// Sums over the families, one value an owned particle: what materials::FamilySums holds.
struct StrainSums {
  std::vector<double> extension, plastic, square;
  std::vector<double> total;                    ///< with kinematic hardening, where something has flowed; else empty
  std::vector<bonds::Mandel> fit, plastic_fit;  ///< [moments] sum omega xi N e weight, and of e_p
};

/// What the materials see of the sums of particle i. of_fit, plastic_fit: its own, read where its strain is fitted;
/// fit: what they say then.
materials::FamilySums family_sums(const Scene& scene, const Committed& committed, const StrainSums& strains,
                                  LocalIndex i, bonds::Mandel of_fit, bonds::Mandel plastic_fit,
                                  materials::StrainFit& fit);

/// Coefficients of every owned particle's tangent: see materials::PointState and PointModulus. [owned] each.
struct TangentLaw {
  std::vector<double> radial, shear;  ///< of the force state: t = omega (radial xi + shear e - yielded e_p)
  std::vector<double> yielded;        ///< empty where it is shear everywhere
  std::vector<double> mean;           ///< theta/d
  std::vector<double> dilatation;     ///< coefficient of (omega xi)(omega xi . de)
  std::vector<double> flow;           ///< coefficient of q (q . de)
  // [moments], in the order of Families::moments. Fitted particles' `radial` is zero, and their `dilatation` that of an
  // isotropic fit, for their neighbours' diagonal blocks.
  std::vector<bonds::Mandel> state;             ///< t = omega (shear e - yielded e_p + xi N . H)
  std::vector<bonds::Mandel> slope;             ///< q = omega (e - e_p + xi N . g)
  std::vector<std::array<double, 36>> modulus;  ///< A of materials::strain_modulus
};

/// Bytes on this rank of the arrays that a run of a scene comes to hold in its loops.
struct LoopMemory {
  std::size_t evaluation = 0;  ///< strain sums and internal force
  std::size_t tangent = 0;     ///< products; diagonal blocks need twelve arrays more for a moment, 30 with fits
  std::size_t plastic = 0;     ///< plastic extension, once everything has flowed; nothing where nothing has
};

/// True where some material has kinematic hardening.
bool has_back_stress(const Scene& scene);

/// The loops over the bonds of one scene, and their arrays: internal force, tangent product, diagonal blocks, growth of
/// plastic extension, all on the same sweeps. What an elastic or a small-strain scene does not need is not in its
/// loops. Arrays with "local" hold ghosts too; those of ghosts' families are other ranks' business.
class FamilyLoops {
 public:
  static std::unique_ptr<FamilyLoops> make(const Scene& scene);
  /// For strain_sums only, which then have `fit` and `plastic_fit` of every owned particle, in their order.
  static std::unique_ptr<FamilyLoops> make_for_tensors(const Scene& scene, bool small_strain);
  virtual ~FamilyLoops() = default;
  FamilyLoops(const FamilyLoops&) = delete;
  FamilyLoops& operator=(const FamilyLoops&) = delete;

  /// Strains at displacement [local * dimension], ghosts up to date. shift: [owned], subtracted as FamilySums has it.
  /// The displacement is kept for forces().
  void strain_sums(const double* displacement, const double* shift, const PlasticExtension& plastic, StrainSums& sums);
  /// Internal force at the displacement of the last strain_sums: [local * dimension], what this rank's families exert
  /// on owned particles and on ghosts.
  /// radial, shear, yielded: [owned], yielded null as a whole where it is shear; state: [moments] as in TangentLaw.
  void forces(const double* radial, const double* shear, const double* yielded, const bonds::Mandel* state,
              const PlasticExtension& plastic, double* force);

  /// What the work of a step along its chord leaves out because bonds turn, if every bond keeps the force that it has
  /// at the displacement of the last strain_sums: sum t (de - M . dU), over this rank's families. step: [local *
  /// dimension], ghosts up to date; the law as in forces(). Zero with small strains.
  double turning_work(const double* radial, const double* shear, const double* yielded, const bonds::Mandel* state,
                      const PlasticExtension& plastic, const double* step);

  /// strain_sums and forces for time steps: the halo's messages travel while bonds without ghosts are worked on.
  /// displacement: [local * dimension], ghosts are filled here; force: [owned * dimension], complete. Collective.
  void moving_sums(double* displacement, const double* shift, const PlasticExtension& plastic, StrainSums& sums);
  void moving_forces(const double* radial, const double* shear, const double* yielded, const bonds::Mandel* state,
                     const PlasticExtension& plastic, double* force);

  /// Keeps the state that the next products are taken at. displacement: [local * dimension], ghosts up to date. The
  /// plastic extension is read by every product: it has to stay.
  virtual void linearise(const double* displacement, const TangentLaw& law, const PlasticExtension& plastic) = 0;
  /// y = K x. x, y: [owned * dimension]. Collective; the halo's messages travel while bonds without ghosts are worked
  /// on.
  void product(const double* x, double* y);
  /// Diagonal blocks, row-major: [local * dimension^2], this rank's families' share.
  virtual void diagonal_blocks(const TangentLaw& law, double* blocks) = 0;

  /// e_p += flow (e - mean xi - e_p) for the families that flow. displacement: [local * dimension]; mean, flow:
  /// [owned].
  virtual void advance(const double* displacement, const double* mean, const double* flow,
                       PlasticExtension& plastic) = 0;

  /// To be called when bonds of the scene have broken.
  virtual void bonds_changed() {}

  /// What the arrays will take.
  virtual LoopMemory expected() const = 0;
  /// Bytes of the arrays held here now.
  virtual std::size_t bytes() const = 0;

 protected:
  /// What the loops are for.
  struct Purpose {
    bool small_strain;
    bool tensors;  ///< sums of tensors at every particle
  };
  FamilyLoops(const Scene& scene, Purpose purpose);

  /// The bonds that reach no ghost, or the others.
  enum class Bonds { inner, outer };
  /// The steps of strain_sums, in this order; those with a range or bonds once for either.
  virtual void begin_strains(const double* shift) = 0;
  virtual void put_displacement(const double* displacement, LocalIndex first, LocalIndex last) = 0;
  virtual void sweep_strains(Bonds bonds, const PlasticExtension& plastic) = 0;
  virtual void take_strains(bool flowed, StrainSums& sums) const = 0;
  /// The steps of forces, before take_forces.
  virtual void begin_forces(const double* radial, const double* shear, const double* yielded,
                            const bonds::Mandel* state) = 0;
  virtual void sweep_forces(Bonds bonds, const PlasticExtension& plastic) = 0;
  /// The step of turning_work after begin_forces. step: [local * dimension].
  virtual double sweep_turning(const PlasticExtension& plastic, const double* step) = 0;
  /// The steps of a product, in this order; those with a range once for either.
  virtual void put_direction(const double* x, LocalIndex first, LocalIndex last) = 0;  ///< of particles first to last
  virtual void clear_sums() = 0;
  virtual void product_sums(Bonds bonds) = 0;
  virtual void product_law() = 0;  ///< what the points make of their sums; clears the forces
  virtual void product_forces(Bonds bonds) = 0;
  virtual void take_forces(LocalIndex first, LocalIndex last, double* y) const = 0;

  /// What a product makes of the sums of a fitted particle: [mandel_size], and its second sum.
  struct FitChange {
    bonds::Mandel change{};
    double flow = 0;
  };
  FitChange change_of_fit(std::size_t m, const bonds::Mandel& sums, double second, double flow) const;
  /// Keeps what products and diagonal blocks need of the law.
  void keep_fits(const TangentLaw& law);

  bool alone() const { return local_ == owned_ && halo_.neighbors() == 0; }

  body::Halo halo_;
  int d_, owned_, local_;
  bool back_stress_;  ///< some material has one, and `yielded` its own place
  int fit_of(LocalIndex i) const { return fit_of_.empty() ? -1 : fit_of_[i]; }

  std::vector<LocalIndex> fitted_;    ///< [moments] the particle
  std::vector<std::int32_t> fit_of_;  ///< Families::fit
  std::vector<bonds::Mandel> slope_;
  std::vector<std::array<double, 36>> modulus_;
  std::vector<double> ghosts_;  ///< [local * d] of which only ghosts' entries are used
};

}  // namespace perinox::mechanics
