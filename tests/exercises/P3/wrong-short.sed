# mistake: printed-short, stage 1
s/ %.17g %.17g %.17g %.17g"/ %g %g %g %g"/
