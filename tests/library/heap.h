/* Counts the blocks of memory in use: what is forgotten to be freed shows.
   To be included by one file of a program, since it takes the place of
   malloc and free. Under a sanitizer, which looks for leaks itself, and
   with a C library other than GNU's the count stays 0. */
#ifndef HEAP_H
#define HEAP_H

#include "unit.h"

#include <errno.h>
#include <stddef.h>

static long heap_blocks;

/* So many requests more succeed, then one fails; below 0: none does. */
static long heap_failing = -1;

#if defined __has_feature
#if __has_feature(address_sanitizer)
#define HEAP_SANITIZED
#endif
#endif
#if defined __GLIBC__ && !defined __SANITIZE_ADDRESS__ &&                  \
    !defined HEAP_SANITIZED

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);
void *__libc_memalign(size_t, size_t);
void __libc_free(void *);

static bool heap_refuses(void)
{
    return heap_failing >= 0 && heap_failing-- == 0;
}

static void *heap_count(void *block)
{
    if (block)
        __atomic_add_fetch(&heap_blocks, 1, __ATOMIC_RELAXED);
    return block;
}

void *malloc(size_t bytes)
{
    return heap_refuses() ? NULL : heap_count(__libc_malloc(bytes));
}

void *calloc(size_t n, size_t bytes)
{
    return heap_refuses() ? NULL : heap_count(__libc_calloc(n, bytes));
}

void *realloc(void *block, size_t bytes)
{
    if (heap_refuses())
        return NULL;
    void *again = __libc_realloc(block, bytes);
    return block ? again : heap_count(again);
}

int posix_memalign(void **block, size_t alignment, size_t bytes)
{
    if (heap_refuses())
        return ENOMEM;
    *block = heap_count(__libc_memalign(alignment, bytes));
    return *block ? 0 : ENOMEM;
}

void *aligned_alloc(size_t alignment, size_t bytes)
{
    return heap_refuses() ? NULL
                          : heap_count(__libc_memalign(alignment, bytes));
}

/* GNU's asks for memory, and does without: a refusal would not be noticed.
 */
void qsort(void *list, size_t n, size_t size,
           int (*compare)(const void *, const void *))
{
    char *at = list, one[256];
    for (size_t gap = n / 2; gap > 0; gap /= 2)
        for (size_t i = gap; i < n; ++i) {
            size_t k = i;
            memcpy(one, at + i * size, size);
            for (; k >= gap && compare(at + (k - gap) * size, one) > 0;
                 k -= gap)
                memcpy(at + k * size, at + (k - gap) * size, size);
            memcpy(at + k * size, one, size);
        }
}

void free(void *block)
{
    if (block)
        __atomic_sub_fetch(&heap_blocks, 1, __ATOMIC_RELAXED);
    __libc_free(block);
}
#endif

/* Does it with the first request for memory failing, then with the second,
   and so on, until none has failed: passes if it says each time that it
   failed, and leaves no block behind. Returns how many requests it makes.
 */
static inline long heap_fails(const char *what, bool (*does)(void *),
                              void *with, bool spared)
{
    const long before = heap_blocks;
    for (long k = 0; k < 100000; ++k) {
        heap_failing = k;
        const bool well = does(with);
        const bool refused = heap_failing < 0;
        heap_failing = -1;
        if (heap_blocks != before)
            printf(
                "# %s: %ld blocks are not freed when request %ld fails\n",
                what, heap_blocks - before, k + 1);
        if (well && refused && !spared)
            printf("# %s: says nothing when request %ld fails\n", what,
                   k + 1);
        UNIT_TRUE(heap_blocks == before &&
                  (refused ? spared || !well : well));
        if (!refused || heap_blocks != before)
            return k;
    }
    UNIT_TRUE(false);
    return 0;
}

/* Does it once, for what is kept for good, and once more: passes if that
   leaves as many blocks in use as there were. */
static inline void heap_stays(const char *what, void (*does)(void *),
                              void *with)
{
    does(with);
    const long before = heap_blocks;
    does(with);
    if (heap_blocks != before)
        printf("# %s: %ld blocks are not freed\n", what,
               heap_blocks - before);
    UNIT_EQUAL(heap_blocks, before);
}

#endif
