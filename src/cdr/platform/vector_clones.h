#pragma once

/// Stands before a function with a hot loop over arrays. The compiler also makes a version for wider vectors,
/// and the processor runs the widest that it has. Results are the same to the bit, since nothing is
/// contracted. Empty for compilers without this, and under sanitizers, which start after the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && __GNUC__ >= 12 && defined(__linux__) &&                      \
    !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CDR_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define CDR_VECTOR_CLONES
#endif
