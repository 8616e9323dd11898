# mistake: half-the-time, stage 4
s/k < 2 \* rows \* every/k < rows * every/
