# mistake: seed-ignored, stage 4
s/ ^ ((uint64_t)seed \* [0-9u]*)/ + 0 * (uint64_t)seed/
