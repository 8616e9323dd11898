# mistake: rows-at-events, stage 3
s/^            ++pairs;/            ++pairs;\
            break;/
s/^            ++walls;/            ++walls;\
            break;/
s/^    now = end;//
s/^        go_on((double)k \* tc);$/        if (k)\
            go_on(INFINITY);/
s/printf("%.17g", (double)k \* tc)/printf("%.17g", now)/
