# Measures, on this machine, the times in the speed tables of the chapters.
bench: programs
	build/bin/collide-forms --study cost --collisions 10000000
	build/bin/bonkers-studies --study speed --summary build/ratios
	@cat build/ratios
	build/bin/bonkers-studies --study steps
	$(if $(gsl),build/bin/bonkers --preset thermal --every 0.24 \
		--samples 400000 -o - | build/bin/histogram --skip 1 \
		--column v9 --table cost -)
	build/bin/piston --study cost --velocity 0.1
	build/bin/disks-studies --study speed
	for packing in .3 .7; do \
		build/bin/disks-speed --packing $$packing || exit 1; done
	for packing in .30 .49; do build/bin/disks-speed \
		--dimensions 3 --packing $$packing || exit 1; done
	build/bin/step-studies --study cost
	build/bin/scene-speed
	build/bin/disks-speed --steps --particles 1e4 --dimensions 3 \
		--packing .49
	build/bin/springs-studies --study speed
	build/bin/springs-studies --study threads
	build/bin/springs-studies --study work -o - | tail -n +7
	build/bin/gravity-studies --study speed
	build/bin/gravity-studies --study threads
	build/bin/gravity-studies --study tree
	build/bin/gravity-studies --study two-suns
	build/bin/bonk-studies --study prices
	build/bin/scene sun-earth | build/bin/step - \
		--until 90000 --every 9000 --summary - -o build/bench.dat | \
		grep steps_per_second
	@$(MAKE) -j 2 --output-sync=target --no-print-directory bench-errors

# Measures error against processor time for small systems. Two runs are made at the same time,
# each on its own processor.
bench_rooms = bench-room-.05 bench-room-.15 bench-room-.2
bench_errors = bench-chains bench-spheres $(bench_rooms) bench-pressure
.PHONY: bench bench-errors $(bench_errors)
bench-errors: $(bench_errors)
bench-chains:
	build/bin/sample-studies --study pressure --samples 4e5
bench-spheres:
	build/bin/spheres-studies --study cost --runs 2
$(bench_rooms): bench-room-%:
	build/bin/sample-studies --study cost --samples 4e7 --radii $* \
		--step $(step)
bench-room-.05: step = .4
bench-room-.15: step = .2
bench-room-.2: step = .15
bench-pressure:
	build/bin/disks-studies --study pressure --samples 330000
