# mistake: tunnelled, stage 6
# Only where they are after the step.
s/if (sigma == 0 || b >= 0 || under < 0)/if (sigma == 0 || apart(to, i, j) > sigma)/
