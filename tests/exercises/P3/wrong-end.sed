# mistake: end-of-the-step, stage 6
s/t + first \* dt/t + dt/
