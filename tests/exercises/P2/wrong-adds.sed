# mistake: clock-adds-up, stage 3
s/go_on((double)k \* tc)/go_on(k ? now + tc : 0)/; s/printf("%.17g", (double)k \* tc)/printf("%.17g", now)/
