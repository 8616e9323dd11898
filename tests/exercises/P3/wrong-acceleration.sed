# mistake: force-as-acceleration, stage 1
# There is no gravity in stage 1.
s/along \/ mass\[\([ij]\)\]/along \/ (gravity > 0 ? mass[\1] : 1)/
