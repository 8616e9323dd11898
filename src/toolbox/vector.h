/* Compiles loops for several kinds of processor and chooses at run time. */
#ifndef TOOLBOX_VECTOR_H
#define TOOLBOX_VECTOR_H

#include <limits.h> /* for __GLIBC__ */

/* VECTOR_LOOP stands before a function of plain loops: gcc compiles it once
   for each kind of processor, and its first call chooses a version (ifunc,
   so glibc only; sanitizers must be loaded before that; -DVECTOR_PLAIN is
   for tests that compare the bytes). The versions differ only in how many
   numbers an instruction takes: with -ffp-contract=off the compiler may
   neither reorder a sum nor round once instead of twice, so all give the
   same bytes. A loop that rounds otherwise must not be marked so: it gets a
   name of its own, as the kernels of gravity do.

   VECTOR_LONG asks for gcc's -O3, since only that level vectorises whole
   loops, which does not pay for short ones. */
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

/* VECTOR_AVX2 and VECTOR_AVX512 stand before a function that is written
   with these instructions; it may be called only if VECTOR_HAS(kind) is
   true. They are undefined for compilers and processors without them. */
#ifdef VECTOR_HAS
#define VECTOR_AVX2 VECTOR_LONG __attribute__((target("avx2")))
#define VECTOR_AVX512 __attribute__((target("avx512f")))
#endif

/* Returns the widest kind of instructions that plain loops use on this
   machine: "avx512", "avx2" or "plain". */
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
