# mistake: points-touch, stage 6
s/if (sigma == 0 || b >= 0/if (b >= 0/
