# mistake: old-force, stage 2
/^static void leap/,/^}/{
s/^{$/{\n    double a[2 * MOST];\n    accelerate(s, a);/
s/^    drift(s, t);$/&\n    for (int c = 0; c < 2 * n; ++c)\n        s->v[c] += a[c] * t \/ 2;\n    return;/
}
