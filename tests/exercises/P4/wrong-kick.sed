# mistake: last-kick-forgotten, stage 1, given 0 1 2 3
# Two half kicks are made into one, and that after the last step is not made.
/^static void hop/,/^}/{
s/^    push(r, h \/ 2);$/    push(r, (h + pending) \/ 2);/
/^    ask(r);$/{
s/$/\n    pending = h;/
n
d
}
}
s/^static void hop/static double pending;\nstatic void hop/
s/^    struct run r;$/    struct run r;\n    pending = 0;/
