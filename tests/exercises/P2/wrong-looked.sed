# mistake: looks-of-collisions, stage 5
/^    ++looks;$/d; s/++pairs;/++pairs, ++looks;/
