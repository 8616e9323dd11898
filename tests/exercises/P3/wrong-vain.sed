# mistake: refused-in-vain, stage 5
s/if (dt > limit) {/if (dt > limit \/ 3) {/
