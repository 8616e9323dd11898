# mistake: first-order, stage 3
s/if (method == EULER) {/if (method != LEAPFROG) {/
