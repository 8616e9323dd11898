/* From chapters/10-springs.nw: edit there, then run make tangle. */
/* checksum 3547811235 of the lines below */
/* Finds normal modes: Jacobi rotations diagonalise the stiffness matrix. */
#include "forces/modes.h"

#include "forces/largest.h"

#include <math.h>
#include <stdlib.h>

void modes_free(struct modes *m)
{
    free(m->coordinate);
    free(m->square);
    free(m->shape);
    free(m->weight);
    *m = (struct modes){0};
}

static bool make_room(struct modes *m, const struct springs *p)
{
    *m = (struct modes){0};
    for (size_t i = 0; i < 3 * p->bodies; ++i)
        m->size += p->inverse[i] > 0;
    m->coordinate = malloc((m->size + 1) * sizeof *m->coordinate);
    m->square = malloc((m->size + 1) * sizeof *m->square);
    m->shape = calloc(m->size * m->size + 1, sizeof *m->shape);
    m->weight = malloc((m->size + 1) * sizeof *m->weight);
    if (!m->coordinate || !m->square || !m->shape || !m->weight)
        return false;
    for (size_t i = 0, at = 0; i < 3 * p->bodies; ++i)
        if (p->inverse[i] > 0) {
            m->weight[at] = p->inverse[i];
            m->coordinate[at++] = i;
        }
    return true;
}

/* Computes the second derivatives of a spring's energy with respect to the
   vector between its ends: (10.10, eq:spring-stiffness). */
static void stiffness_of(const struct springs *p,
                         const struct scene_spring *s, const double x[],
                         double k[3][3])
{
    const double stiffness = p->kind[s->kind].stiffness;
    double d[3], square = 0;
    for (size_t a = 0; a < 3; ++a) {
        d[a] = x[a * p->bodies + s->b] - x[a * p->bodies + s->a];
        square += d[a] * d[a];
    }
    const bool alike = s->rest == 0; /* the stiffness is isotropic */
    const double across =
        alike ? stiffness : stiffness * (1 - s->rest / sqrt(square));
    for (size_t a = 0; a < 3; ++a)
        for (size_t b = 0; b < 3; ++b)
            k[a][b] =
                (alike ? 0 : (stiffness - across) * d[a] * d[b] / square) +
                (a == b ? across : 0);
}

/* Adds the stiffness of one spring to the matrix. The row of coordinate c
   is place[c] - 1; place[c] is 0 if the coordinate is fixed. */
static void add_spring(const struct springs *p,
                       const struct scene_spring *s, const double x[],
                       const size_t place[], size_t size, double matrix[])
{
    const size_t end[2] = {s->a, s->b};
    double k[3][3];
    stiffness_of(p, s, x, k);
    for (size_t i = 0; i < 36; ++i) {
        const size_t a = i % 3, b = i / 3 % 3, e = i / 9 % 2, f = i / 18;
        const size_t row = a * p->bodies + end[e];
        const size_t column = b * p->bodies + end[f];
        if (place[row] == 0 || place[column] == 0)
            continue;
        const double scale = sqrt(p->inverse[row] * p->inverse[column]);
        matrix[(place[row] - 1) * size + place[column] - 1] +=
            (e == f ? 1 : -1) * scale * k[a][b];
    }
}

/* Adds all springs to a zero matrix. Returns false if memory runs out. */
static bool assemble(const struct modes *m, const struct springs *p,
                     const double x[], double matrix[])
{
    size_t *const place = calloc(3 * p->bodies + 1, sizeof *place);
    if (!place)
        return false;
    for (size_t i = 0; i < m->size; ++i)
        place[m->coordinate[i]] = i + 1;
    for (size_t i = 0; i < p->count; ++i)
        add_spring(p, &p->spring[i], x, place, m->size, matrix);
    free(place);
    return true;
}

/* Rotates two rows of an array by the angle with cosine c and sine s.
   Element k of a row is `step` numbers after element k - 1. */
static void turn(double *row_i, double *row_j, size_t n, size_t step,
                 double c, double s)
{
    for (size_t k = 0; k < n * step; k += step) {
        const double a = row_i[k], b = row_j[k];
        row_i[k] = c * a - s * b;
        row_j[k] = s * a + c * b;
    }
}

/* Makes element (i, j) of the n x n matrix zero by a rotation, and applies
   the rotation to shape. */
static void rotate(double matrix[], double shape[], size_t n, size_t i,
                   size_t j)
{
    const double off = matrix[i * n + j];
    const double half = (matrix[j * n + j] - matrix[i * n + i]) / 2;
    const double root = sqrt(half * half + off * off);
    const double t = (half < 0 ? -1 : 1) * off / (fabs(half) + root);
    const double c = 1 / sqrt(1 + t * t), s = t * c;
    turn(matrix + i * n, matrix + j * n, n, 1, c, s);
    turn(matrix + i, matrix + j, n, n, c, s);
    turn(shape + i * n, shape + j * n, n, 1, c, s);
}

/* Rotates all pairs of rows repeatedly until the matrix is diagonal. */
static void diagonalize(double matrix[], double shape[], size_t n)
{
    const double small = 1e-16 * largest(matrix, n * n);
    for (int sweep = 0, turned = 1; turned > 0 && sweep < 50; ++sweep) {
        turned = 0;
        for (size_t i = 0; i < n; ++i)
            for (size_t j = i + 1; j < n; ++j)
                if (fabs(matrix[i * n + j]) > small) {
                    rotate(matrix, shape, n, i, j);
                    ++turned;
                }
    }
}

/* Sorts the modes by the squares of their frequencies. */
static void put_in_order(struct modes *m)
{
    const size_t n = m->size;
    for (size_t i = 0; i < n; ++i) {
        size_t least = i;
        for (size_t j = i + 1; j < n; ++j)
            least = m->square[j] < m->square[least] ? j : least;
        const double square = m->square[i];
        m->square[i] = m->square[least];
        m->square[least] = square;
        for (size_t k = 0; k < n && least != i; ++k) {
            const double a = m->shape[i * n + k];
            m->shape[i * n + k] = m->shape[least * n + k];
            m->shape[least * n + k] = a;
        }
    }
}

bool modes_find(struct modes *m, const struct springs *p, const double x[])
{
    const bool roomy = make_room(m, p);
    const size_t n = m->size;
    double *matrix = roomy ? calloc(n * n + 1, sizeof *matrix) : NULL;
    if (!matrix || !assemble(m, p, x, matrix)) {
        free(matrix);
        modes_free(m);
        return false;
    }
    for (size_t i = 0; i < n; ++i)
        m->shape[i * n + i] = 1;
    diagonalize(matrix, m->shape, n);
    for (size_t i = 0; i < n; ++i)
        m->square[i] = matrix[i * n + i];
    free(matrix);
    put_in_order(m);
    return true;
}

void modes_deflection(const struct modes *m, double least, const double a[],
                      double u[])
{
    for (size_t i = 0; i < m->size; ++i)
        u[m->coordinate[i]] = 0;
    for (size_t j = 0; j < m->size; ++j) {
        const double *const shape = m->shape + j * m->size;
        double push = 0;
        if (m->square[j] < least)
            continue;
        for (size_t i = 0; i < m->size; ++i)
            push += shape[i] * a[m->coordinate[i]] / sqrt(m->weight[i]);
        for (size_t i = 0; i < m->size; ++i)
            u[m->coordinate[i]] +=
                push / m->square[j] * shape[i] * sqrt(m->weight[i]);
    }
}
