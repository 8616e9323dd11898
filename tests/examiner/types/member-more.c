/* 12a does not build: the structure has a member of the student's own */
/* says: .c:8:16: error: members changed in 'struct */
/* says: struct choice has other members than the exercise gave: struct choice { double cost; double error; } */
#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct choice {
    double cost, error;
    bool beaten;
} choice;

size_t pareto_front(size_t n, const struct choice c[], size_t front[])
{
    size_t count = 0;
    for (size_t i = 0; i < n; ++i) {
        bool beaten = false;
        for (size_t j = 0; j < n; ++j)
            beaten |= c[j].cost < c[i].cost && c[j].error < c[i].error;
        if (!beaten)
            front[count++] = i;
    }
    return count;
}
