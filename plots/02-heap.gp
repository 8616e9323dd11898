# alt: A tree of ten numbered circles in four levels, each with a time that is not earlier than that of the circle above it; below it the same ten times in a row of boxes numbered 0 to 9. The circles 9, 4 and 1 are marked: an entry that has become 1.4 climbs from 9 past 4 to 1.
height = 6.4
load 'plots/style.gp'
unset border
unset tics
set margins 0,0,0,0
set size ratio -1
set xrange [-0.5:14.5]
set yrange [-2.15:4.75]
array T = [1.2, 1.9, 1.5, 4.0, 2.3, 3.1, 2.8, 5.2, 4.4, 2.6]
array X = [7.2, 3.6, 10.8, 1.8, 5.4, 9.2, 12.4, 0.9, 2.7, 4.6]
array Y = [4.15, 3.0, 3.0, 1.85, 1.85, 1.85, 1.85, 0.7, 0.7, 0.7]
climbs(k) = k == 9 || k == 4 || k == 1
do for [k=0:9] {
    if (k > 0) {
        j = (k-1)/2
        set arrow 10+k from X[j+1],Y[j+1] to X[k+1],Y[k+1] nohead lw (climbs(k) && climbs(j) ? 2.2 : 1)*thick lc rgb climbs(k) && climbs(j) ? red : grey back
    }
    set object 10+k circle at X[k+1],Y[k+1] size 0.42 fc rgb climbs(k) ? '#f7d9c4' : '#ffffff' fs solid border lc rgb climbs(k) ? red : '#333333' lw 1.2*thick front
    set label 10+k sprintf('%.1f', T[k+1]) at X[k+1],Y[k+1] center front
    set label 30+k sprintf('%d', k) at X[k+1]+(k > 0 && k%2 == 0 ? 0.5 : -0.5),Y[k+1]+0.36 center tc rgb '#555555'
    set object 30+k rectangle from 2.2+k,-1.2 to 3.2+k,-0.5 fc rgb climbs(k) ? '#f7d9c4' : '#ffffff' fs solid border lc rgb climbs(k) ? red : '#333333' lw 1.2*thick
    set label 50+k sprintf('%.1f', T[k+1]) at 2.7+k,-0.85 center front
    set label 70+k sprintf('%d', k) at 2.7+k,-1.5 center tc rgb '#555555'
}
set arrow 60 from 6.25,0.55 to 5.15,0.65 size 0.2,25 lw 1.2*thick lc rgb red
set label 60 'becomes 1.4' at 6.4,0.55 left tc rgb red
set label 61 'entry' at 1.9,-1.5 right tc rgb '#555555'
set label 62 'time' at 1.9,-0.85 right tc rgb '#555555'
plot 1/0
