/* From chapters/B-grader.nw: edit there, then run make tangle. */
/* checksum 3153963431 of the lines below */
#include "examiner/publish.h"
#include <stdio.h>
#include <string.h>
bool publish_known(const char *r)
{
    return strstr("table,csv,gradescope,classroom50,junit", r) != NULL;
}
void publish(const char *report, const struct course *c, const char *folder)
{
    (void)folder;
    if (strcmp(report, "table"))
        return;
    for (size_t i = 0; i < c->students * c->exercises; ++i) {
        const struct marks *m = &c->marks[i];
        printf("%-12s %s %-14s %d/%d + %d/%d  %.2f s (build %.2f) tries %d "
               " [%s]\n",
               m->student, m->exercise, state_name(m->state),
               marks_earned(m, 0), marks_possible(m, 0), marks_earned(m, 1),
               marks_possible(m, 1), m->seconds, m->build_seconds, m->tries,
               m->file);
    }
}
