# mistake: places-independent, stage 5
s/sqrt((ww - 2 \* q \* wm + q \* q \* mm) \* n \/ (n - 1)) \/ in_middle/q * sqrt(1 \/ at_wall + 1 \/ in_middle)/
