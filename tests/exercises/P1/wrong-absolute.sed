# mistake: false-alarm, stage 4, given 7
# 1e-9 of what, when the beads are heavy?
s/1e-10 \* size/1e-9 + 0 * size/
s/1e-10 \* e)/1e-9)/
