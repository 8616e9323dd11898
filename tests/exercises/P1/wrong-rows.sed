# mistake: rows-at-collisions, stage 1
# One event a row, and its time.
s/now + wait > end/now > end || once++/
s/^static void go_to/static int once;\n&/
s/go_to((double)k \* tick);/once = 0, go_to(INFINITY);/
s/fly(end - now);/return;/
s/print_row((double)k \* tick)/print_row(now)/
