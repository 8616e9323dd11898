# mistake: printed-short, stage 3
s/%.17g/%.15f/g
