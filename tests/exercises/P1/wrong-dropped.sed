# mistake: small-g-dropped, stage 5
s/^    read_beads/    g = g < 1.1e-6 ? 0 : g;\n&/
