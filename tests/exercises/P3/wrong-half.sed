# mistake: error-of-the-half-step, stage 4
s/error \/ (1 - pow(0.5, order\[method\]))/error \/ (pow(2, order[method]) - 1)/
