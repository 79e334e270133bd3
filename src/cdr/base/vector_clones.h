#pragma once

/// Before a function with a hot loop over arrays: compiled for wider vectors too, and the widest that the
/// processor has runs. Results are the same to the bit, since nothing is contracted. Nothing where the
/// compiler cannot, and not under sanitizers, which are not up yet when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && defined(__linux__) && !defined(__clang__) &&                 \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CDR_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CDR_VECTOR_CLONES
#endif
