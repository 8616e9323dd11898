# mistake: row-0-counted, stage 5
/static void watch/,/^}/s/go_on((double)k \* tc)/go_on((double)(k - 1) * tc)/
