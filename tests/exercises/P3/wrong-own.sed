# mistake: own-mass, stage 2
/gravity > 0 && i-- > 1;)$/,/;$/s/pull(/own(/
s/^static void accelerate/static void own(const struct state *s, double a[], int i, int j, double f)\
{\
    pull(s, a, i, j, f);\
    for (int c = 0; c < 2; ++c) {\
        const double way = f * (s->x[2 * j + c] - s->x[2 * i + c]);\
        a[2 * i + c] += way \/ mass[j] - way \/ mass[i];\
        a[2 * j + c] -= way \/ mass[i] - way \/ mass[j];\
    }\
}\
\
&/
