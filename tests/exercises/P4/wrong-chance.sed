# mistake: agreed-by-chance, stage 2, given 0 1 2 3
# Two runs that agree are enough.
s/ \&\& before <= 4 \* tolerance)/)/
