# mistake: check-gives-up, stage 4
s/if (!(fabs(/if (collisions < 1000 \&\& !(fabs(/
