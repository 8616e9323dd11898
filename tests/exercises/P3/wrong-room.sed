# mistake: too-little-room, stage 2
# Twenty seem to be enough.
s/enum { MOST = 64 }/enum { MOST = 20 }/
