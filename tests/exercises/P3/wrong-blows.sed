# mistake: blows-up, stage 5
s/if (dt > limit) {/if (dt > 10 * limit) {/
