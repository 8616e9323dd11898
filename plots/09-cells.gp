# alt: A square that is divided into cells. Round a cross somewhat left of the middle the cells are small; with the distance they grow, each ring of cells twice as wide as the one inside it.
width = 9
height = 6.4
load 'plots/style.gp'
unset border
unset tics
set size ratio -1
set margins 0,0,0,0
set xrange [-0.35:1.35]
set yrange [-0.05:1.05]
x0 = 0.36
y0 = 0.43
theta = 0.5
deep = 5
w(k) = 0.5**k
far(k, i, j) = sqrt((x0 - w(k)*(i + 0.5))**2 + (y0 - w(k)*(j + 0.5))**2)
# whether the cell looks small enough, and whether all those round it did not
small(k, i, j) = w(k) < theta*far(k, i, j)
open(k, i, j) = k == 0 ? 1 : (!small(k - 1, floor(i/2), floor(j/2)) && open(k - 1, floor(i/2), floor(j/2)))
n = 0
do for [k=0:deep] {
  do for [i=0:2**k-1] {
    do for [j=0:2**k-1] {
      if (open(k, i, j) && (small(k, i, j) || k == deep)) {
        n = n + 1
        set object n rect from w(k)*i,w(k)*j to w(k)*(i+1),w(k)*(j+1) fc rgb (k == deep ? '#f3d3c2' : k % 2 ? '#cfe3f1' : '#eef4f9') fs solid border lc rgb (k == deep ? red : blue) lw 0.8*thick
      }
    }
  }
}
plot '+' using (x0):(y0) every ::0::0 with points pt 2 ps 1.2*big lw 2*thick lc rgb dark
