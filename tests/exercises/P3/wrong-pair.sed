# mistake: first-pair, stage 6
s/if (part < first) {/if (part < first \&\& first > 1) {/
