# mistake: counts-of-all, stage 4
s/print_histogram(2.0 \* n/print_histogram(1.0 * n/
