# mistake: nearest-approach, stage 6
s/return c \/ (sqrt(under) - b);/return -b \/ ww;/
