# mistake: calls-of-the-pick, stage 6, given 0 1 2 3
s/n%.17g", calls, end_time/n%.17g", (long)price(best.order, (double)best.steps), end_time/
