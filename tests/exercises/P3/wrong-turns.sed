# mistake: one-by-one, stage 2
s/^        kick(s, t);$/        for (int i = 0; i < n; ++i) {\n            double a[2 * MOST];\n            accelerate(s, a);\n            for (int c = 2 * i; c < 2 * i + 2; ++c)\n                s->x[c] += (s->v[c] += a[c] * t) * t;\n        }/
/^        drift(s, t);$/d
