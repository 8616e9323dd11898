# mistake: touching-refused, stage 1
s/d\.p\[c\] >= radius/d.p[c] > radius/
