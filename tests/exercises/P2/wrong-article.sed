# mistake: article-clock, stage 3
# The loop of the article, as exercise 05c has it.
s/^static void print_rows/static int hit, by;\
\
static double soonest(void)\
{\
    double first = INFINITY;\
    for (int i = 0; i < disks; ++i)\
        for (int j = -2; j < i; ++j) {\
            const int c = -1 - j;\
            const double t = j < 0 ? to_wall(disk[i].p[c], disk[i].v[c])\
                                   : to_meet(disk + i, disk + j);\
            if (t < first) {\
                first = fmax(t, 0);\
                hit = i;\
                by = j;\
            }\
        }\
    return first;\
}\
\
static void by_article(double tc)\
{\
    static double event = -1;\
    if (event < 0)\
        event = soonest();\
    now += tc;\
    if (now < event) {\
        fly(tc);\
        return;\
    }\
    fly(event - now - tc);\
    if (by < 0)\
        disk[hit].v[-1 - by] *= -1;\
    else\
        collide(disk + hit, disk + by);\
    now = event;\
    event = now + soonest();\
}\
\
&/
s/^        go_on((double)k \* tc);$/        if (k)\
            by_article(tc);/
