/* Allocates outputs with known bytes before and after each. */
#include "examiner/guards.h"
#include "examiner/remote.h"
#include "examiner/transport.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Each output lies between two guards of 512 doubles, since an index meant
   for another array may be off by that much. Without guards, a function
   could write beyond the end of an array, into the kit's memory, and still
   get full points. */
enum { GUARD = 4096, MOST = 8 };

/* Returns byte i of a guard. Eight of these bytes, read as a double, are a
   NaN; read as a size_t, they are larger than any index. So a function
   gains nothing by reading them. */
static unsigned char filling(size_t i)
{
    static const unsigned char bytes[] = {0xa5, 0xa5, 0xa5, 0xa5,
                                          0xa5, 0xa5, 0xfa, 0x7f};
    return bytes[i % sizeof bytes];
}

/* Returns the bytes of an unchanged guard, filled in by the first call. */
static const unsigned char *untouched(void)
{
    static unsigned char guard[GUARD];
    for (size_t i = 0; guard[GUARD - 1] == 0; ++i)
        guard[i] = filling(i);
    return guard;
}

static struct place {
    const char *name;
    unsigned char *before, *behind; /* the guards of an output */
} places[MOST];
static size_t used;

#ifdef __ELF__
#define WEAK __attribute__((weak))
void __asan_poison_memory_region(const volatile void *x, size_t n) WEAK;
void __asan_unpoison_memory_region(const volatile void *x, size_t n) WEAK;

/* Forbids access to the guards of an output, or allows it again if `on` is
   false. The address sanitizer then also notices a read, and reports its
   line. The two functions are weak symbols, which are NULL without a
   sanitizer, because the same driver is used in programs with and without
   sanitizers. Only ELF has weak symbols. */
static void forbid(const struct place *p, bool on)
{
    void (*const tell)(const volatile void *x, size_t n) =
        on ? __asan_poison_memory_region : __asan_unpoison_memory_region;
    if (tell) {
        tell(p->before, GUARD);
        tell(p->behind, GUARD);
    }
}
#else
static void forbid(const struct place *p, bool on)
{
    (void)p, (void)on;
}
#endif

void *remote_output(const char *name, size_t bytes)
{
    if (used == MOST)
        transport_lost();
    struct place *p = &places[used++];
    p->name = name;
    p->before = remote_memory(remote_bytes(bytes, 1) + 2 * GUARD);
    p->behind = p->before + GUARD + bytes;
    memcpy(p->before, untouched(), GUARD);
    memcpy(p->behind, untouched(), GUARD);
    forbid(p, true);
    return p->before + GUARD;
}

double *remote_output_doubles(const char *name, size_t count)
{
    double *x = remote_output(name, remote_bytes(count, sizeof *x));
    remote_doubles(x, count);
    return x;
}

size_t *remote_output_sizes(const char *name, size_t count)
{
    size_t *x = remote_output(name, remote_bytes(count, sizeof *x));
    remote_sizes(x, count);
    return x;
}

int *remote_output_ints(const char *name, size_t count)
{
    int *x = remote_output(name, remote_bytes(count, sizeof *x));
    remote_ints(x, count);
    return x;
}

static int changed(const unsigned char *guard)
{
    int count = 0;
    if (memcmp(guard, untouched(), GUARD) == 0)
        return 0;
    for (size_t i = 0; i < GUARD; ++i)
        count += guard[i] != filling(i);
    return count;
}

bool guards_overrun(struct check_overrun *overrun)
{
    for (struct place *p = places; p < places + used; ++p) {
        forbid(p, false);
        const int before = changed(p->before), behind = changed(p->behind);
        if (before == 0 && behind == 0)
            continue;
        *overrun = (struct check_overrun){
            .before = behind == 0, .bytes = behind ? behind : before};
        snprintf(overrun->place, sizeof overrun->place, "%s", p->name);
        return true;
    }
    return false;
}

void guards_clear(void)
{
    while (used > 0) {
        forbid(&places[--used], false);
        free(places[used].before);
    }
}
