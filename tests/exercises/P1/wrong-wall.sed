# mistake: wall-with-a-mass, stage 1
s/v\[i\] = -v\[i\];/v[i] *= (m[i] - 1e5) \/ (m[i] + 1e5);/
