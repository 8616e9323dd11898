# mistake: no-reaction, stage 1
/a\[2 \* j + axis\] -= along/d
