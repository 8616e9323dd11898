# mistake: whole-kicks, stage 2
s/^    kick(s, t \/ 2);/    kick(s, t);/
