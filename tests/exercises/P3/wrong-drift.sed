# mistake: drift-first, stage 2
/^static void leap/,/^}/{
s/drift(s, t);/kick(s, t);/
s/kick(s, t \/ 2)/drift(s, t \/ 2)/
}
