# mistake: whole-kicks, stage 2
s/^    kick(s, 0.5 \* t);/    kick(s, t);/
