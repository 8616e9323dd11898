# mistake: one-body-alone, stage 4
/^    double error/,$s/i < n/i < 1/
