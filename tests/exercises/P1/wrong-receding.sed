# mistake: receding-pair, stage 1
s/if (closing <= 0)/if (closing == 0 || gap < 1e-9)/
s/fmax(gap, 0) \/ closing/gap \/ fabs(closing)/
s/x\[i\] = x\[i + 1\] = .*;/;/
