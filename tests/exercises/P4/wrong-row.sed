# mistake: row-of-the-other-run, stage 2, given 0 1 2 3
# The run of twice the steps is printed.
s/const struct run \*r = &best.end;/const struct run other = go(best.order, 2 * best.steps), *r = \&other;/
