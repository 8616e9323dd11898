# mistake: reach-of-two-radii, stage 6
s/0\.5, n, reach)/0.5, n, reach + small)/
s/low + width, n, reach)/low + width, n, reach + small)/
