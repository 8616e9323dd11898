# mistake: price-without-square, stage 5
s/pow(100 \* error \/ q, 2)/pow(100 * error \/ q, 1)/
