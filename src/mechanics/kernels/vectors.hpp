#pragma once
/// Vectors of doubles for the sweeps, as wide as the machine they are compiled for. To be included with
/// PERINOX_KERNELS, the namespace of the instruction set.
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define PERINOX_INLINE inline __attribute__((always_inline))

namespace perinox::mechanics::kernels::PERINOX_KERNELS {

#if defined(__AVX512F__)
constexpr int width = 8;
#else
constexpr int width = 4;
#endif

typedef double Vector __attribute__((vector_size(width * 8)));
typedef std::int64_t Lanes __attribute__((vector_size(width * 8)));
typedef double Unaligned __attribute__((vector_size(width * 8), aligned(8), may_alias));
typedef double Row __attribute__((vector_size(32)));
typedef double LooseRow __attribute__((vector_size(32), aligned(8), may_alias));

PERINOX_INLINE Vector all(double value) { return value - Vector{}; }
#if defined(PERINOX_CHECKED_ACCESS)
static_assert(width == 4);
/// In halves: the address sanitiser has a quick check for sixteen bytes and a slow one for more.
typedef double Half __attribute__((vector_size(16), aligned(8), may_alias));
PERINOX_INLINE Row row(const double* from) {
  const Half low = *reinterpret_cast<const Half*>(from), high = *reinterpret_cast<const Half*>(from + 2);
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
PERINOX_INLINE void put_row(double* to, Row value) {
  *reinterpret_cast<Half*>(to) = __builtin_shufflevector(value, value, 0, 1);
  *reinterpret_cast<Half*>(to + 2) = __builtin_shufflevector(value, value, 2, 3);
}
PERINOX_INLINE Vector load(const double* from) { return row(from); }
PERINOX_INLINE void store(double* to, Vector value) { put_row(to, value); }
#else
PERINOX_INLINE Row row(const double* from) { return *reinterpret_cast<const LooseRow*>(from); }
PERINOX_INLINE void put_row(double* to, Row value) { *reinterpret_cast<LooseRow*>(to) = value; }
PERINOX_INLINE Vector load(const double* from) { return *reinterpret_cast<const Unaligned*>(from); }
PERINOX_INLINE void store(double* to, Vector value) { *reinterpret_cast<Unaligned*>(to) = value; }
#endif
PERINOX_INLINE double total(Vector value) {
  double sum = value[0];
  for (int lane = 1; lane < width; ++lane) sum += value[lane];
  return sum;
}

/// The lanes whose bit is set; 0 elsewhere, also where the value is not a number.
PERINOX_INLINE Vector chosen(unsigned mask, Vector value) {
#if defined(__AVX512F__)
  return reinterpret_cast<Vector>(_mm512_maskz_mov_pd(static_cast<__mmask8>(mask), reinterpret_cast<__m512d>(value)));
#else
  const Lanes bits = {1, 2, 4, 8};
  const Lanes on = (static_cast<std::int64_t>(mask) & bits) != 0;
  return reinterpret_cast<Vector>(reinterpret_cast<Lanes>(value) & on);
#endif
}

/// 1/sqrt to rounding, for s = |Y|^2 that is not zero: the machine's estimate (2^-12 or better), refined with four
/// terms of the series of (1 - h)^(-1/2), h = 1 - s r^2. `scale` is any number near 1/s, for the estimates in single
/// precision.
template <class Scale>
PERINOX_INLINE Vector inverse_root(Vector s, Scale scale, Scale root_scale) {
#if defined(__AVX512F__)
  (void)scale, (void)root_scale;
  const Vector r = reinterpret_cast<Vector>(_mm512_rsqrt14_pd(reinterpret_cast<__m512d>(s)));
#elif defined(__x86_64__)
  const Vector scaled = s * scale;
  const auto narrow = __builtin_convertvector(scaled, float __attribute__((vector_size(16))));
  const auto estimate = _mm_rsqrt_ps(reinterpret_cast<__m128>(narrow));
  typedef float Narrow __attribute__((vector_size(16)));
  const Vector r = __builtin_convertvector(reinterpret_cast<Narrow>(estimate), Vector) * root_scale;
#else
  Vector r;
  for (int lane = 0; lane < width; ++lane) r[lane] = 1 / __builtin_sqrt(s[lane]);
  (void)scale, (void)root_scale;
#endif
  const Vector h = 1.0 - s * r * r;
  const Vector series = ((35.0 / 128 * h + 5.0 / 16) * h + 3.0 / 8) * h + 0.5;
  return r + r * h * series;
}

/// The four doubles of each of the slots, one vector a component.
PERINOX_INLINE void gather(const double* from, const std::int32_t* slot, Vector* to) {
#if defined(__AVX512F__)
  Vector half[4];
  for (int k = 0; k < 4; ++k)
    half[k] = __builtin_shufflevector(row(from + 4 * slot[k]), row(from + 4 * slot[k + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
  const Vector a = __builtin_shufflevector(half[0], half[1], 0, 8, 2, 10, 4, 12, 6, 14);
  const Vector b = __builtin_shufflevector(half[0], half[1], 1, 9, 3, 11, 5, 13, 7, 15);
  const Vector c = __builtin_shufflevector(half[2], half[3], 0, 8, 2, 10, 4, 12, 6, 14);
  const Vector d = __builtin_shufflevector(half[2], half[3], 1, 9, 3, 11, 5, 13, 7, 15);
  to[0] = __builtin_shufflevector(a, c, 0, 1, 8, 9, 4, 5, 12, 13);
  to[1] = __builtin_shufflevector(b, d, 0, 1, 8, 9, 4, 5, 12, 13);
  to[2] = __builtin_shufflevector(a, c, 2, 3, 10, 11, 6, 7, 14, 15);
  to[3] = __builtin_shufflevector(b, d, 2, 3, 10, 11, 6, 7, 14, 15);
#else
  const Row r0 = row(from + 4 * slot[0]), r1 = row(from + 4 * slot[1]);
  const Row r2 = row(from + 4 * slot[2]), r3 = row(from + 4 * slot[3]);
  const Row a = __builtin_shufflevector(r0, r1, 0, 4, 2, 6), b = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Row c = __builtin_shufflevector(r2, r3, 0, 4, 2, 6), d = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  to[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
  to[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  to[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
  to[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
#endif
}

/// Adds one vector a component to the first `count` doubles of each slot. Slots may be equal only where what is added
/// does not matter.
PERINOX_INLINE void scatter(double* to, const std::int32_t* slot, const Vector* from, int count) {
  if (count == 1) {
    for (int lane = 0; lane < width; ++lane) to[4 * slot[lane]] += from[0][lane];
    return;
  }
  const Vector f0 = from[0], f1 = from[1], f2 = count > 2 ? from[2] : Vector{}, f3 = count > 3 ? from[3] : Vector{};
#if defined(__AVX512F__)
  const Vector a = __builtin_shufflevector(f0, f1, 0, 8, 2, 10, 4, 12, 6, 14);  // lanes 0, 2, 4, 6: components 0, 1
  const Vector b = __builtin_shufflevector(f0, f1, 1, 9, 3, 11, 5, 13, 7, 15);
  const Vector c = __builtin_shufflevector(f2, f3, 0, 8, 2, 10, 4, 12, 6, 14);
  const Vector d = __builtin_shufflevector(f2, f3, 1, 9, 3, 11, 5, 13, 7, 15);
  const Row rows[8] = {__builtin_shufflevector(a, c, 0, 1, 8, 9),   __builtin_shufflevector(b, d, 0, 1, 8, 9),
                       __builtin_shufflevector(a, c, 2, 3, 10, 11), __builtin_shufflevector(b, d, 2, 3, 10, 11),
                       __builtin_shufflevector(a, c, 4, 5, 12, 13), __builtin_shufflevector(b, d, 4, 5, 12, 13),
                       __builtin_shufflevector(a, c, 6, 7, 14, 15), __builtin_shufflevector(b, d, 6, 7, 14, 15)};
#else
  const Vector a = __builtin_shufflevector(f0, f1, 0, 4, 2, 6), b = __builtin_shufflevector(f0, f1, 1, 5, 3, 7);
  const Vector c = __builtin_shufflevector(f2, f3, 0, 4, 2, 6), d = __builtin_shufflevector(f2, f3, 1, 5, 3, 7);
  const Row rows[4] = {__builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(b, d, 0, 1, 4, 5),
                       __builtin_shufflevector(a, c, 2, 3, 6, 7), __builtin_shufflevector(b, d, 2, 3, 6, 7)};
#endif
  for (int lane = 0; lane < width; ++lane) {
    double* at = to + 4 * slot[lane];
    put_row(at, row(at) + rows[lane]);
  }
}

}  // namespace perinox::mechanics::kernels::PERINOX_KERNELS
