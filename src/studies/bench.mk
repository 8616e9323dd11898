# The speed tables of the chapters, on this machine.
.PHONY: bench
bench: native build/bin/disks-speed build/bin/gravity-studies
	build/native/bin/collide-forms --study cost --collisions 10000000
	build/native/bin/bonkers-studies --study speed --summary build/ratios
	@cat build/ratios
	build/native/bin/bonkers-studies --study steps
	$(if $(gsl),build/native/bin/bonkers --preset thermal --every 0.24 \
		--samples 400000 -o - | build/native/bin/histogram --skip 1 \
		--column v9 --table cost -)
	build/native/bin/piston --study cost --velocity 0.1
	build/native/bin/disks-studies --study speed
	build/native/bin/disks-studies --study pressure --samples 330000
	for radius in '.05 --step .4' '.15 --step .2' '.2 --step .15'; do \
		build/native/bin/sample-studies --study cost --samples 4e7 \
			--radii $$radius || exit 1; done
	for packing in .3 .7; do \
		build/native/bin/disks-speed --packing $$packing || exit 1; done
	for packing in .30 .49; do build/native/bin/disks-speed \
		--dimensions 3 --packing $$packing || exit 1; done
	build/native/bin/step-studies --study cost
	build/native/bin/scene-speed
	for bin in build/bin build/native/bin; do $$bin/disks-speed --steps \
		--particles 1e4 --dimensions 3 --packing .49 || exit 1; done
	build/native/bin/springs-studies --study speed
	build/native/bin/springs-studies --study threads
	build/native/bin/springs-studies --study work -o - | tail -n +7
	build/native/bin/spheres-studies --study cost --runs 4
	build/bin/gravity-studies --study speed
	build/bin/gravity-studies --study threads
	build/bin/gravity-studies --study tree
	build/bin/gravity-studies --study two-suns
	build/bin/bonk-studies --study prices
	build/native/bin/scene sun-earth | build/native/bin/step - \
		--until 90000 --every 9000 --summary - -o build/bench.dat | \
		grep steps_per_second
