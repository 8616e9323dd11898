# mistake: rows-independent, stage 5
s/each = rows \/ BLOCKS/each = 1/; s/each \* BLOCKS/rows/g
