# mistake: one-end-fixed, stage 5
s/sqrt(fastest(&now))/sqrt(spring[0].k \/ mass[0])/
