# data: plots/data/01-cost.dat
# alt: Five moments of one collision, time upwards, twice. From the ground a light ball comes from the left, hits a heavy one at rest and goes back, slower, while the heavy one moves off. Seen from the centre of mass both come in, and both go back as fast as they came.
height = 6.4
load 'plots/style.gp'
# 1 kg at 1 m/s meets 4 kg at rest.
m1 = 1.0; m2 = 4.0; u1 = 1.0; u2 = 0.0
c = (m1*u1 + m2*u2)/(m1 + m2)
v1 = 2*c - u1; v2 = 2*c - u2
r1 = 0.17; r2 = 0.34
x1(t) = -r1 + (t < 0 ? u1 : v1)*t
x2(t) = r2 + (t < 0 ? u2 : v2)*t
middle(t) = (m1*x1(t) + m2*x2(t))/(m1 + m2)
set multiplot layout 1,2 margins 0.055,0.995,0.03,0.9 spacing 0.03,0
unset border
unset xtics
set ytics nomirror scale 0 offset 1,0 ('2 s' 2, '1 s' 1, '0' 0, '−1 s' -1, '−2 s' -2)
set size ratio -1
set yrange [-2.55:2.55]
do for [panel=1:2] {
    moving = panel == 2
    set title (moving ? 'from the centre of mass' : 'from the ground') offset 0,-0.5
    set xrange [-2.45:1.95]
    if (moving) { unset ytics }
    do for [k=0:4] {
        t = k - 2.0
        s = moving ? middle(t) : 0.0
        set object 10+k circle at x1(t)-s,t size r1 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
        set object 20+k circle at x2(t)-s,t size r2 fc rgb '#f7d9c4' fs solid border lc rgb red lw 1.5*thick
        w1 = (t < 0 ? u1 : v1) - (moving ? c : 0)
        w2 = (t < 0 ? u2 : v2) - (moving ? c : 0)
        if (t != 0) {
            set arrow 10+k from x1(t)-s,t to x1(t)-s+0.62*w1,t lw 2*thick lc rgb dark front
            if (abs(w2) > 0) { set arrow 20+k from x2(t)-s,t to x2(t)-s+0.62*w2,t lw 2*thick lc rgb dark front } else { unset arrow 20+k }
        }
    }
    set arrow 1 from (moving ? 0 : middle(-2.4)),-2.4 to (moving ? 0 : middle(2.4)),2.4 nohead dt 3 lw 1.5*thick lc rgb '#555555' back
    plot 1/0
}
