/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 332917280 of the lines below */
/* Loops compiled for several processors; the one at hand is found out. */
#ifndef TOOLBOX_VECTOR_H
#define TOOLBOX_VECTOR_H

#include <limits.h> /* for __GLIBC__ */

/* Before a function of loops: one version for each kind of processor, and
   the same bytes from all. Needs -ffp-contract=off. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(VECTOR_PLAIN)
#define VECTOR_HAS(kind) __builtin_cpu_supports(kind)
#if !defined(__clang__) && defined(__GLIBC__) &&                           \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VECTOR_CLONES
#define VECTOR_LONG __attribute__((optimize("O3")))
#if __GNUC__ >= 12
#define VECTOR_LOOP                                                        \
    VECTOR_LONG                                                            \
    __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define VECTOR_LOOP                                                        \
    VECTOR_LONG __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#endif
#endif
#ifndef VECTOR_CLONES
#define VECTOR_LONG
#define VECTOR_LOOP
#endif

/* Before a function that is written in the instructions of a kind: call it
   only if VECTOR_HAS() has said so. Undefined where there are none. */
#ifdef VECTOR_HAS
#define VECTOR_AVX2 VECTOR_LONG __attribute__((target("avx2")))
#define VECTOR_AVX512 __attribute__((target("avx512f")))
#endif

/* Returns the widest kind of instructions that the plain loops use here:
   "avx512", "avx2" or "plain". */
static inline const char *vector_kind(void)
{
#ifdef VECTOR_CLONES
    if (VECTOR_HAS("avx512f") && VECTOR_HAS("avx512vl") &&
        VECTOR_HAS("avx512dq") && VECTOR_HAS("avx512bw"))
        return "avx512";
    if (VECTOR_HAS("avx2"))
        return "avx2";
#endif
    return "plain";
}

#endif
