# The methods of chapter 8, as a figure shows them that has all. A figure loads
# this file after its style and asks its data which methods there are: those
# that are named here have a name and a style of their own, in all chapters;
# others come after them, in orange, under the names of their rows.
known = 'euler symplectic-euler leapfrog implicit-midpoint rk4 yoshida4 yoshida6 pefrl kahan-li8 gauss4 rk8pd wisdom-holman sbab4 dopri5 radau15'
array called[15] = ['Euler', 'sympl. Euler', 'leapfrog', 'midpoint', 'RK4', 'Yoshida 4', 'Yoshida 6', 'PEFRL', 'Kahan–Li 8', 'Gauss 4', 'rk8pd (GSL)', 'Wisdom–Holman', 'SBAB4', 'dopri5', 'radau15']
if (!exists("size")) size = 1
sky = '#56b4e9'
brown = '#6b3e12'
umber = '#9a6a3a'
set style line 20 lc rgb orange pt 3 ps 0.7*size*big lw 1.5*thick
set style line 21 lc rgb umber pt 5 ps 0.6*size*big lw 1.5*thick
set style line 22 lc rgb green pt 9 ps 0.7*size*big lw 1.5*thick
set style line 23 lc rgb blue pt 7 ps 0.6*size*big lw 1.5*thick
set style line 24 lc rgb blue pt 6 ps 0.6*size*big lw 1.5*thick dt 2
set style line 25 lc rgb purple pt 11 ps 0.7*size*big lw 1.5*thick
set style line 26 lc rgb dark pt 13 ps 0.8*size*big lw 1.5*thick
set style line 27 lc rgb dark pt 12 ps 0.8*size*big lw 1.5*thick dt 2
set style line 28 lc rgb green pt 8 ps 0.7*size*big lw 1.5*thick dt 2
set style line 29 lc rgb red pt 4 ps 0.6*size*big lw 1.5*thick dt 2
set style line 30 lc rgb purple pt 10 ps 0.7*size*big lw 1.5*thick dt 2
set style line 31 lc rgb grey pt 1 ps 0.7*size*big lw thick
set style line 32 lc rgb orange pt 2 ps 0.7*size*big lw 1.5*thick dt 2
set style line 33 lc rgb orange pt 14 ps 0.7*size*big lw 1.5*thick
set style line 34 lc rgb sky pt 14 ps 0.7*size*big lw 1.5*thick
set style line 35 lc rgb brown pt 15 ps 0.7*size*big lw 1.5*thick
place(name) = sum [i=1:words(known)] (word(known,i) eq name ? i : 0)
name_of(name) = place(name) ? called[place(name)] : name
style_of(name) = 20 + place(name)

# methods(file, order): those whose points follow a line "# name", the known
# ones in this order and the others after them, !name left out; at(file, name):
# how many are before that one. columns and column_of: the same in a table that
# has a column for each.
listed(heading, field, order, file) = system("awk -v order='".order."' '/^# ".heading."/ && !seen[$".field."]++ { found[++n] = $".field." } END { for (k = split(order, w, \" \"); i < k;) { m = w[++i]; hidden = sub(/^!/, \"\", m); if (m in seen && !hidden) print m; done[m] = 1 } for (i = 0; i < n;) if (!(found[++i] in done)) print found[i] }' '".file."' | tr '\\n' ' '")
first(script, file) = int(real(system("awk '".script."' '".file."'")))
methods(file, order) = listed('[a-z][-a-z0-9]*$', '2', order, file)
columns(file, order) = listed('[0-9]+ [a-z][-a-z0-9]* [[]', '3', order, file)
at(file, name) = first('/^# [a-z][-a-z0-9]*$/ { if ($2 == "'.name.'") { print n + 0; exit } ++n }', file)
column_of(file, name) = first('/^# [0-9]+ / && $3 == "'.name.'" { print $2; exit }', file)
