# mistake: spread-of-one-throw, stage 4
s/^                   places \/ width);/                   places \/ width * sqrt(n));/
