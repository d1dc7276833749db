#pragma once

// LACUNA_VECTOR_CLONES before a function with loops worth it: compiled for three generations of x86-64 vector units, the
// one at hand chosen when the program starts. Results are those of the plain version to the bit where its file is
// compiled with -ffp-contract=off. Nothing elsewhere, and under sanitizers, which do not know such functions.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define LACUNA_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define LACUNA_VECTOR_CLONES
#endif
