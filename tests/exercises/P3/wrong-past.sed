# mistake: meeting-in-the-past, stage 6
s/sigma == 0 || b >= 0 || under < 0/sigma == 0 || under < 0/
