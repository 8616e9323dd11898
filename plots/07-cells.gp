# alt: A square of three by three cells, in the middle one a dark disk. Many disks lie about, each with a cross not far from it, its anchor. A large circle around the anchor of the dark disk holds the crosses of fifteen blue disks, its neighbours, all of them in the nine cells; each of these and the dark one have a small dashed circle around their cross, as far as its skin lets it go, and the disk's centre is inside. The other disks are pale.
width = 9
height = 9
load 'plots/style.gp'
# x, y of a disk, x, y of its anchor, and 2: the dark one, 1: a neighbour.
# 120 disks of diameter 1 at packing 0.3 after 4000 collisions, what is
# around one of them; five cells along a side of the box, of this width:
cell = 3.5449
skin = 1.2678
$disks << EOD
7.506 9.814 8.026 9.396 2
9.465 12.662 9.518 12.455 1
8.069 7.069 8.438 6.969 1
8.975 8.149 9.222 7.643 1
6.700 8.986 6.415 9.079 1
11.462 10.761 10.619 11.099 1
7.974 10.733 8.194 11.028 1
7.673 8.059 7.633 8.175 1
9.639 9.447 10.274 9.118 1
9.179 10.455 9.761 10.334 1
5.955 10.536 5.017 10.309 1
4.778 8.886 4.797 8.906 1
8.391 13.700 7.588 12.859 1
11.663 7.778 11.464 8.899 1
6.285 6.807 6.481 6.958 1
6.858 11.545 5.998 10.883 1
11.981 2.913 10.834 2.959 0
13.560 10.933 13.956 11.008 0
9.709 4.401 10.602 4.841 0
13.811 5.411 14.271 5.604 0
15.097 14.316 15.560 14.547 0
2.834 13.222 3.004 13.309 0
7.356 4.286 7.295 4.746 0
10.893 8.664 11.419 8.089 0
6.613 3.509 7.278 2.977 0
9.472 3.175 9.476 2.999 0
2.832 8.454 3.980 8.147 0
3.748 12.816 4.149 13.063 0
5.086 12.392 4.744 12.916 0
5.524 13.562 5.546 13.259 0
13.760 7.623 14.329 6.586 0
11.512 5.374 10.858 5.851 0
5.125 4.741 4.997 4.891 0
8.032 5.913 8.136 5.719 0
5.134 3.692 6.210 3.896 0
13.794 9.336 13.813 8.956 0
12.894 8.566 12.890 8.073 0
12.638 9.742 12.339 9.134 0
9.765 14.435 8.533 14.349 0
15.245 8.801 15.151 8.824 0
8.658 5.098 9.522 4.868 0
14.716 10.505 15.295 10.948 0
7.743 2.543 8.779 2.218 0
14.841 7.323 15.308 7.604 0
3.587 15.218 4.091 15.118 0
12.387 4.727 12.657 5.683 0
4.376 6.702 4.770 6.893 0
7.044 13.557 6.303 14.523 0
15.011 3.402 16.144 3.676 0
11.564 13.069 11.257 13.731 0
12.846 6.952 12.909 6.528 0
5.518 5.731 5.583 6.541 0
13.472 12.996 12.618 12.917 0
11.511 9.696 12.413 10.517 0
4.219 11.335 3.777 11.016 0
6.416 4.888 6.542 5.108 0
4.003 8.008 4.197 6.997 0
12.233 11.921 11.695 11.961 0
12.539 10.902 12.447 10.836 0
13.155 14.342 13.249 14.020 0
EOD
unset border
unset tics
set size ratio -1
set margins 0,0,0,0
set xrange [cell-0.6:4*cell+0.6]
set yrange [cell-0.6:4*cell+0.6]
ax = real(word($disks[1],3))
ay = real(word($disks[1],4))
set object 1 rectangle from cell,cell to 4*cell,4*cell fc rgb '#f1f1f1' fs solid noborder behind
do for [k=1:4] {
  set arrow 2*k from k*cell,cell-0.6 to k*cell,4*cell+0.6 nohead lc rgb '#aaaaaa' lw 0.8*thick back
  set arrow 2*k+1 from cell-0.6,k*cell to 4*cell+0.6,k*cell nohead lc rgb '#aaaaaa' lw 0.8*thick back
}
set object 2 circle at ax,ay size 1+2*skin fs empty border lc rgb red lw 2*thick front
plot $disks using ($5 == 0 ? $1 : NaN):2:(0.5) with circles fs solid fc rgb '#dddddd' lc rgb '#dddddd', \
     '' using ($5 == 1 ? $1 : NaN):2:(0.5) with circles fs solid fc rgb '#9dc6e3' lc rgb blue, \
     '' using ($5 == 2 ? $1 : NaN):2:(0.5) with circles fs solid fc rgb '#1f3a4d' lc rgb dark, \
     '' using ($5 > 0 ? $3 : NaN):4:(skin) with circles fs empty lc rgb '#777777' dt 2 lw 0.8*thick, \
     '' using ($5 == 0 ? $3 : NaN):4 with points pt 2 ps 0.5*big lc rgb '#888888', \
     '' using ($5 == 1 ? $3 : NaN):4 with points pt 2 ps 0.7*big lw 1.5*thick lc rgb blue, \
     '' using ($5 == 2 ? $3 : NaN):4 with points pt 2 ps 0.9*big lw 2.5*thick lc rgb red
