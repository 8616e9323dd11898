# One style for all figures. A script sets width and height in cm if they are
# not 14 and 7, loads this file, draws, and that is all: medium (pdf, svg or
# lecture) and output come from the Makefile. By hand: gnuplot plots/01-drift.gp
# draws build/figure.svg.
if (!exists("medium")) medium = 'svg'
if (!exists("output")) output = 'build/figure.svg'
if (!exists("width")) width = 14
if (!exists("height")) height = 7

# A lecture slide is 16:9: the book's figure, as much larger as it is wider,
# with all its type, lines and points. One that is much taller has a slide for
# each row: its script says how many (# slides: 3) and draws those that row()
# lets it.
face = 'Latin Modern Sans'
lecture = medium eq 'lecture'
thick = lecture ? 2.3 : 1
big = lecture ? 2.2 : 1
if (!exists("slide")) slide = 0
row(k) = slide == 0 || slide == k
if (medium eq 'pdf') set terminal pdfcairo size width*1cm,height*1cm font face.',9' fontscale 0.75 enhanced
if (medium eq 'svg') set terminal svg size int(width*48),int(height*48) font face.',DejaVu Sans,sans-serif,15' enhanced background rgb 'white'
if (lecture) set terminal pdfcairo size 32cm,18cm font face.',20' fontscale 0.75 enhanced
set output output
set encoding utf8
set minussign

# Colours that differ in lightness and to colour-blind eyes (Okabe and Ito),
# each with a point of its own shape, so that greyscale will do.
dark = '#000000'
blue = '#0072b2'
red = '#d55e00'
green = '#009e73'
purple = '#aa4499'
orange = '#e69f00'
grey = '#999999'
set style line 1 lc rgb blue pt 7 ps 0.6*big lw 1.5*thick
set style line 2 lc rgb red pt 5 ps 0.6*big lw 1.5*thick
set style line 3 lc rgb green pt 9 ps 0.7*big lw 1.5*thick
set style line 4 lc rgb purple pt 11 ps 0.7*big lw 1.5*thick
set style line 5 lc rgb dark pt 13 ps 0.8*big lw 1.5*thick
set style line 9 lc rgb grey lw 1.0*thick           # theory, guides
set border lw 0.8*thick lc rgb '#333333'
set tics scale 0.6
# gnuplot 6 labels the minor tics of a short logarithmic axis, one label on another:
# `eval decades` after set logscale sets those that gnuplot 5 has by itself.
decades = "set xtics (1); set for [k=-3:5] xtics add (10.0**k); ".\
    "set for [k=-3:5] for [j=2:9] xtics add ('' j*10.0**k 1)"
# The sides of the axes, as shares of the figure: `eval edges(0.1, 0.98, 0.15, 0.97)`.
edges(left, right, bottom, top) = sprintf("set lmargin at screen %.17g; ".\
    "set rmargin at screen %.17g; set bmargin at screen %.17g; ".\
    "set tmargin at screen %.17g", left, right, bottom, top)
# Both axes logarithmic, with powers of ten: `eval powers`.
powers = "set logscale xy; set format '10^{%T}'"
# A picture without axes, with the same scale across and up: `eval drawing`.
drawing = "unset border; unset tics; set size ratio -1"
# What a figure says of a run it reads: from the run's summary, as \result does
# in the text, and from the head of a table. What is not there ends the drawing.
result(run, key) = real(system("sed -n 's/^".key." //p' build/runs/".run.".summary"))
head(file, what) = system("sed -n 's/^# ".what.": //p' '".file."'")
option(file, name) = system("sed -n 's/^# command: .* --".name." \\([^ ]*\\).*/\\1/p' '".file."'")
mass(file, i) = real(word(head(file, 'masses'), i))
set key noautotitle
set xlabel offset 0,0.55
