# mistake: looks-of-events, stage 5
/^    ++looks;$/d; s/++pairs;/++pairs, ++looks;/; s/++walls;/++walls, ++looks;/
