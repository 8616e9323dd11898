# mistake: small-g-cancels, stage 5
# The root as it stands in a book.
s/if (v\[i\] > 0)$/if (g > 0)/
