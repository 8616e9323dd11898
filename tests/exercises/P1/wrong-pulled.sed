# mistake: gravity-in-pair-time, stage 5
s/if (closing <= 0)/if (g > 0)\n        return gap > 1e-9 ? (sqrt(closing * closing + 2 * g * gap) - closing) \/ g : INFINITY;\n&/
s/x\[i\] = x\[i + 1\] = .*;/;/
