# mistake: attraction-repels, stage 2
s/sum -= gravity/sum += gravity/
