# mistake: springs-without-energy, stage 1
/sum += spring\[k\].k/d
