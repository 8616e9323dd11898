# mistake: explicit-euler, stage 1
s/^        kick(s, t);$/        const struct state old = *s;\n&/
s/^        drift(s, t);$/        for (int c = 0; c < 2 * n; ++c)\n            s->x[c] += old.v[c] * t;/
