# alt: A row of seven boxes, the days 0 to 5 of a calendar and one more, later. From each box hangs a chain of circles with the numbers of disks: none under day 0 and 1, which are past, two under day 2, which is today, one under day 3, none under day 4, three under day 5, four under later. An arrow points at today.
width = 12
height = 5.6
load 'plots/style.gp'
unset border
unset tics
set margins 0,0,0,0
set xrange [-0.2:10.2]
set yrange [-3.75:1.1]
chain(k) = k == 3 ? '17 4' : k == 4 ? '9' : k == 6 ? '12 3 20' : k == 7 ? '8 1 15 6' : ''
px(k) = k < 7 ? 1.3*k - 0.7 : 9.1
n = 0
do for [k=1:7] {
  past = k < 3
  today = k == 3
  set object 100+k rectangle from px(k)-0.58,0 to px(k)+0.58,0.62 fs solid 1 border lc rgb (today ? red : '#777777') lw (today ? 2 : 1)*thick fc rgb (today ? '#fbeee5' : past ? '#f4f4f4' : '#e7f1f8')
  page = k < 7 ? sprintf('day %d', k-1) : '{/:Italic later}'
  set label 100+k page at px(k),0.31 center front tc rgb (past ? '#999999' : '#333333')
  c = chain(k)
  m = 0
  do for [name in c] {
    y = -0.62 - 0.85*m
    set object 200+n circle at px(k),y size 0.28 fs solid border lc rgb blue lw 1.2*thick fc rgb 'white' front
    set label 200+n name at px(k),y center front
    set arrow 200+n from px(k),y+0.54 to px(k),y+0.29 heads size 0.07,20 filled lc rgb '#555555' lw 1*thick
    m = m + 1
    n = n + 1
  }
}
set label 1 'today' at px(3),0.88 center tc rgb red
plot 1/0
