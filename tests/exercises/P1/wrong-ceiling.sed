# mistake: small-g-cancels, stage 5
s/up = 2 \* room \/ (v\[i\] + sqrt(left))/up = g > 0 ? (v[i] - sqrt(left)) \/ g : room \/ v[i]/
