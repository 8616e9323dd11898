# mistake: limit-of-another-method, stage 5
s/{2, 2, 1.573}/{2, 2, 2}/
