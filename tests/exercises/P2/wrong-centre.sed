# mistake: centre-at-the-wall, stage 1
s/(1 - radius - place)/(1 - place)/; s/(place - radius) \/ -speed/place \/ -speed/
