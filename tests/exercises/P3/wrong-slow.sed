# mistake: leapfrog-is-euler, stage 2
s/if (method == EULER) {/if (method != FOURTH) {/
