# alt: Two sketches. Left, two disks thrown at each other from left and right, both drawn at six equal times along two arcs of parabolas, until they touch near the top. Right, disk 1 rests, and disk 2 stands at six equal distances on a straight line that ends where the two touch.
height = 4.8
load 'plots/style.gp'
eval drawing
set margins 0,0,0,0
set xrange [-1:22.1]
set yrange [-1.1:6.4]
g = 4.0
end = 1.909
x1(t) = 2.0*t
y1(t) = 6.0*t - g/2*t*t
x2(t) = 9 - 2.2*t
y2(t) = 2.5 + 4.6*t - g/2*t*t
sx = 12.2
sy = 0.6
pale1 = '#e7f1f8'
pale2 = '#fbeee5'
do for [k=0:5] {
  t = k*end/5
  last = k == 0 || k == 5
  set object 10+k circle at x1(t),y1(t) size 0.5 fc rgb last ? '#cfe3f1' : pale1 fs solid border lc rgb blue lw (last ? 1.5 : 0.8)*thick
  set object 20+k circle at x2(t),y2(t) size 0.5 fc rgb last ? '#f7d9c4' : pale2 fs solid border lc rgb red lw (last ? 1.5 : 0.8)*thick
  set object 30+k circle at sx+x2(t)-x1(t),sy+y2(t)-y1(t) size 0.5 fc rgb last ? '#f7d9c4' : pale2 fs solid border lc rgb red lw (last ? 1.5 : 0.8)*thick
}
set object 9 circle at sx,sy size 0.5 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set arrow 1 from x1(0),y1(0) to x1(0)+0.55,y1(0)+1.65 lw 2*thick lc rgb dark front
set arrow 2 from x2(0),y2(0) to x2(0)-0.65,y2(0)+1.36 lw 2*thick lc rgb dark front
set arrow 3 from 6.9,2.2 to 6.9,0.9 lw 1.2*thick lc rgb '#555555'
set arrow 4 from sx+9,sy+2.5 to sx+9-1.6,sy+2.5-0.533 lw 2*thick lc rgb dark front
set label 1 '1' at -0.2,-0.15 center front tc rgb blue
set label 2 '2' at 9.2,2.3 center front tc rgb red
set label 3 '1' at sx,sy center front tc rgb blue
set label 4 '2' at sx+9.2,sy+2.3 center front tc rgb red
set label 5 '{/:Italic g}' at 7.15,1.55 tc rgb '#555555'
set label 6 'Δ{/:Bold v}' at sx+7.3,sy+2.9 center front
plot sample [t=0:1] '+' using (x1(t*end)):(y1(t*end)) with lines lc rgb '#88b7d6' lw 1*thick, \
     [t=0:1] '+' using (x2(t*end)):(y2(t*end)) with lines lc rgb '#e3a57c' lw 1*thick, \
     [t=0:1] '+' using (sx+9-4.2*t*end):(sy+2.5-1.4*t*end) with lines lc rgb '#e3a57c' lw 1*thick
