# mistake: printed-short, stage 1
s/ %.17g %.17g", x/ %g %g", x/
