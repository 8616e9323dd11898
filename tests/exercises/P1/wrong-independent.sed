# mistake: rows-as-if-independent, stage 6
s/^enum { MOST = 64, BLOCKS = 100 };/enum { MOST = 64, BLOCKS = 40000 };/
