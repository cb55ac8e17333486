# Draws press.png and press.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot press.gp  (in this folder)
if (!exists('name')) name = 'press'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 1480,540 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 1480,540 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set yrange [0.001:*]
  set logscale xy
  set format '10^{%L}'
  set xlabel 'time on one core, s a model second'
  set grid lt 1 lc rgb '#dddddd'
  set multiplot layout 1,3 margins 0.0641892,0.97,0.4,0.92 spacing 0.0777027,0
  set title "error of distance"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'press.csv' using (strcol('method') eq 'consistent' && column('error_distance') >= 0.001 ? column('seconds') : NaN):(column('error_distance')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'press.csv' using (strcol('method') eq 'consistent' && column('error_distance') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'press.csv' using (strcol('method') eq 'naive' && column('error_distance') >= 0.001 ? column('seconds') : NaN):(column('error_distance')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'press.csv' using (strcol('method') eq 'naive' && column('error_distance') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'press.csv' using (strcol('method') eq 'consistent in float' && column('error_distance') >= 0.001 ? column('seconds') : NaN):(column('error_distance')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'press.csv' using (strcol('method') eq 'consistent in float' && column('error_distance') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'press.csv' using (strcol('method') eq 'explicit' && column('error_distance') >= 0.001 ? column('seconds') : NaN):(column('error_distance')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'press.csv' using (strcol('method') eq 'explicit' && column('error_distance') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'press.csv' using (strcol('method') eq 'default' && column('error_distance') >= 0.001 ? column('seconds') : NaN):(column('error_distance')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'press.csv' using (strcol('method') eq 'default' && column('error_distance') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000507116 && x <= 0.00800341 ? 3.2963e-05 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of contact area"
  unset key
  plot 'press.csv' using (strcol('method') eq 'consistent' && column('error_contact') >= 0.001 ? column('seconds') : NaN):(column('error_contact')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'press.csv' using (strcol('method') eq 'consistent' && column('error_contact') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'press.csv' using (strcol('method') eq 'naive' && column('error_contact') >= 0.001 ? column('seconds') : NaN):(column('error_contact')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'press.csv' using (strcol('method') eq 'naive' && column('error_contact') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'press.csv' using (strcol('method') eq 'consistent in float' && column('error_contact') >= 0.001 ? column('seconds') : NaN):(column('error_contact')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'press.csv' using (strcol('method') eq 'consistent in float' && column('error_contact') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'press.csv' using (strcol('method') eq 'explicit' && column('error_contact') >= 0.001 ? column('seconds') : NaN):(column('error_contact')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'press.csv' using (strcol('method') eq 'explicit' && column('error_contact') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'press.csv' using (strcol('method') eq 'default' && column('error_contact') >= 0.001 ? column('seconds') : NaN):(column('error_contact')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'press.csv' using (strcol('method') eq 'default' && column('error_contact') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000507116 && x <= 0.00800341 ? 0.000238599 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of heat exchanged"
  unset key
  plot 'press.csv' using (strcol('method') eq 'consistent' && column('error_heat') >= 0.001 ? column('seconds') : NaN):(column('error_heat')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'press.csv' using (strcol('method') eq 'consistent' && column('error_heat') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'press.csv' using (strcol('method') eq 'naive' && column('error_heat') >= 0.001 ? column('seconds') : NaN):(column('error_heat')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'press.csv' using (strcol('method') eq 'naive' && column('error_heat') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'press.csv' using (strcol('method') eq 'consistent in float' && column('error_heat') >= 0.001 ? column('seconds') : NaN):(column('error_heat')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'press.csv' using (strcol('method') eq 'consistent in float' && column('error_heat') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'press.csv' using (strcol('method') eq 'explicit' && column('error_heat') >= 0.001 ? column('seconds') : NaN):(column('error_heat')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'press.csv' using (strcol('method') eq 'explicit' && column('error_heat') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'press.csv' using (strcol('method') eq 'default' && column('error_heat') >= 0.001 ? column('seconds') : NaN):(column('error_heat')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'press.csv' using (strcol('method') eq 'default' && column('error_heat') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000507116 && x <= 0.00800341 ? 0.000108918 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  unset multiplot
  unset output
}
