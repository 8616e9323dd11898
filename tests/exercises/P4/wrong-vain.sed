# mistake: refused-in-vain, stage 7, given 0 1 2 3
# Gives up much too early.
s/steps <= 4 \* LIMIT; steps \*= 2/steps <= LIMIT \/ 10; steps *= 2/
