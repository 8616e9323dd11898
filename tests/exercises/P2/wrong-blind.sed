# mistake: never-overlap-tested, stage 4
s/y\[i\] - y\[j\]) < 2 \* radius/y[i] - y[j]) < 0/
