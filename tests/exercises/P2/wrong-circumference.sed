# mistake: without-circumference, stage 6
s/return s \* pow/return pow/
