# mistake: input-refused, stage 2
# An empty line has no six numbers.
/if (count == 0)/,/continue;/d
