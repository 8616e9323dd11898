/* Compiles loops for several kinds of processors; chooses at run time. */
#ifndef TOOLBOX_VECTOR_H
#define TOOLBOX_VECTOR_H

#include <limits.h> /* for __GLIBC__ */

/* Put VECTOR_LOOP before a function of plain loops. gcc then compiles the
   function for each kind of processor, and the program chooses a version
   when it runs (by ifunc, which only glibc has). The macro has no effect
   with sanitizers, since they would be loaded after the choice. It also has
   no effect with -DVECTOR_PLAIN, which tests use to compare the bytes.

   The versions differ only in the number of values that an instruction
   processes. With -ffp-contract=off, the compiler may neither reorder a sum
   nor round once instead of twice, so all versions give the same bytes. Do
   not use VECTOR_LOOP for a loop that rounds differently. Give such a loop
   a name of its own, as the kernels of gravity do.

   VECTOR_LONG requests gcc's -O3, because only that level vectorises whole
   loops. Short loops do not gain from it. */
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

/* Put VECTOR_AVX2 or VECTOR_AVX512 before a function that is written with
   these instructions. Call such a function only if VECTOR_HAS(kind) is
   true. The macros are undefined for compilers and processors without the
   instructions. */
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
