# mistake: points-meet-nothing, stage 6
s/sigma == 0 || b >= 0/radius[i] == 0 || radius[j] == 0 || b >= 0/
