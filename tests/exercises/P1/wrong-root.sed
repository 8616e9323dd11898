# mistake: wrong-root, stage 5
s/down = (v\[i\] + landing) \/ g;/down = v[i] > landing ? (v[i] - landing) \/ g : INFINITY;/
s/down = 2 \* x\[i\] .*;/down = INFINITY;/
