# mistake: false-alarm, stage 4, given 7
# The momentum that was there, and not those that it is the sum of.
s/^    const double size = .*/    const double size = fabs(p);/
