# mistake: check-gives-up, stage 4, given 7 5 6
s/if (!(fabs(/if (collisions < 1000 \&\& !(fabs(/
