# mistake: second-order, stage 3
# Three leapfrogs, and all of one length.
s/const double out = .*;/const double out = 1 \/ 3.0;/
