# mistake: later-root, stage 1
s/along - sqrt(inside)/along + sqrt(inside)/
