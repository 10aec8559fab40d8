#pragma once

/// Marks a function that is compiled for several instruction sets. The widest one that the machine has is chosen when
/// the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PERINOX_WIDEST __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PERINOX_WIDEST
#endif
