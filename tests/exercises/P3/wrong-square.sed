# mistake: square-of-the-distance, stage 2
s/\(pow(apart(s, i, j), \)3/\12/
