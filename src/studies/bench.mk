# The speed tables of the chapters, on this machine.
.PHONY: bench
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
	build/bin/disks-studies --study pressure --samples 330000
	for radius in '.05 --step .4' '.15 --step .2' '.2 --step .15'; do \
		build/bin/sample-studies --study cost --samples 4e7 \
			--radii $$radius || exit 1; done
	build/bin/sample-studies --study pressure --samples 4e5
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
	build/bin/spheres-studies --study cost --runs 4
	build/bin/gravity-studies --study speed
	build/bin/gravity-studies --study threads
	build/bin/gravity-studies --study tree
	build/bin/gravity-studies --study two-suns
	build/bin/bonk-studies --study prices
	build/bin/scene sun-earth | build/bin/step - \
		--until 90000 --every 9000 --summary - -o build/bench.dat | \
		grep steps_per_second
