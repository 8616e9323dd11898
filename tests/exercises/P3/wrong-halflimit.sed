# mistake: half-the-limit, stage 5
s/stable\[\] = {2, 2,/stable[] = {1, 1,/
