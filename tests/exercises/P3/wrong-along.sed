# mistake: along-x-only, stage 5
# The limit of springs that lie along x.
s/const double ey = .*/const double ey = 0 * d;/
