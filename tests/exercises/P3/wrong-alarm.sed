# mistake: false-meeting, stage 6
# Who passes meets where it is nearest.
s/ || under < 0)/)/
s/sqrt(under)/sqrt(fmax(under, 0))/
