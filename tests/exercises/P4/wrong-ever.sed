# mistake: never-gives-up, stage 7, given 0 1 2 3, never ends
s/steps <= 4 \* LIMIT; steps \*= 2/; steps *= 2/
