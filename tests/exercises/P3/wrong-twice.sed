# mistake: pairs-twice, stage 2
/^static double energy/,/^}/s/j < i; ++j)/j < n; ++j)\n            if (j != i)/
