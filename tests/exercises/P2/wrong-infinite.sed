# mistake: infinite-box, stage 6
s/pow(1 - 2 \* acos(-1) \* reach \* reach + overlap, (double)n)/exp(n * overlap \/ (1 - 2 * acos(-1) * reach * reach))/
