# data: build/data/05-clock.dat
# command: build/bin/disks-studies --study clock -o build/data/05-clock.dat
# lecture: build/bin/disks-studies --study clock --samples 10000000 -o build/data/05-clock.dat
# data: plots/data/disks4_r0.15_unitbox.dat
# alt: Deviation of three histograms from the reference in per cent, for coordinates from 0.15 to 0.5 metres. Ours stays within one per cent of zero. The mended one begins at plus 11, is one or two below zero up to 0.3 and one or two above it in the middle. The article's begins at minus 43, runs at plus 8 between 0.18 and 0.25 and falls to minus 10 in the middle.
load 'plots/style.gp'
file = 'build/data/05-clock.dat'
array R[100]
array A[100]
array B[100]
array C[100]
bin(x) = int(x*100 + 1.5)
stats 'plots/data/disks4_r0.15_unitbox.dat' using (R[bin($1)] = $3) nooutput
stats file using (A[bin($1)] = $2) nooutput
stats file using (B[bin($1)] = $3) nooutput
stats file using (C[bin($1)] = $4) nooutput
off(p, q, k) = 100*((p + q)/2/R[k] - 1)
set xrange [0.15:0.5]
set yrange [-46:16]
set xlabel 'distance from the wall  (m)'
set ylabel 'deviation from the reference  (%)' offset 0.5
eval edges(0.09, 0.98, 0.17, 0.97)
set xzeroaxis ls 9
set key at graph 0.97,0.05 right bottom samplen 1.5
plot sample [k=16:50:1] '+' using ((k-0.5)/100):(off(B[k], B[101-k], k)) with linespoints ls 2 title 'the article''s', \
     [k=16:50:1] '+' using ((k-0.5)/100):(off(C[k], C[101-k], k)) with linespoints ls 3 title 'its sign mended', \
     [k=16:50:1] '+' using ((k-0.5)/100):(off(A[k], A[101-k], k)) with linespoints ls 1 title 'ours'
