# mistake: one-body-alone, stage 4
/^    double error/,$s/int i = n/int i = 1/
