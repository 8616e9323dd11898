# mistake: drift-first, stage 2
/^static void leap/,/^}/{
s/drift(s, t);/kick(s, t);/
s/kick(s, 0.5 \* t)/drift(s, 0.5 * t)/
}
