# mistake: root-zero-again, stage 5, never ends
s/down = (v\[i\] + landing) \/ g;/down = x[i] > 0 ? (v[i] + landing) \/ g : 0;/
s/x\[i\] = v\[i\] < 0 ? 0 : length;/x[i] = v[i] < 0 || g > 0 ? 0 : length;/
s/v\[i\] = -v\[i\];/v[i] = g > 0 ? fabs(v[i]) : -v[i];/
