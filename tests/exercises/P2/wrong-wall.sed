# mistake: one-wall, stage 4
s/printf("# ratio %.17g %.17g\\n# looks %ld\\n", q,/printf("# ratio %.17g %.17g\\n# looks %ld\\n", q \/ 2,/
