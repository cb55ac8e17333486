# Draws squeeze.png and squeeze.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot squeeze.gp  (in this folder)
if (!exists('name')) name = 'squeeze'
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
  set yrange [0.0001:*]
  set logscale xy
  set format '10^{%L}'
  set xlabel 'time on one core, s a model second'
  set grid lt 1 lc rgb '#dddddd'
  set multiplot layout 1,3 margins 0.0641892,0.97,0.4,0.92 spacing 0.0777027,0
  set title "error of bend (fitted)"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'squeeze.csv' using (strcol('method') eq 'consistent' && column('error_bend') >= 0.0001 ? column('seconds') : NaN):(column('error_bend')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'squeeze.csv' using (strcol('method') eq 'consistent' && column('error_bend') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'squeeze.csv' using (strcol('method') eq 'naive' && column('error_bend') >= 0.0001 ? column('seconds') : NaN):(column('error_bend')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'squeeze.csv' using (strcol('method') eq 'naive' && column('error_bend') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'squeeze.csv' using (strcol('method') eq 'consistent in float' && column('error_bend') >= 0.0001 ? column('seconds') : NaN):(column('error_bend')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'squeeze.csv' using (strcol('method') eq 'consistent in float' && column('error_bend') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'squeeze.csv' using (strcol('method') eq 'explicit' && column('error_bend') >= 0.0001 ? column('seconds') : NaN):(column('error_bend')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'squeeze.csv' using (strcol('method') eq 'explicit' && column('error_bend') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'squeeze.csv' using (strcol('method') eq 'default' && column('error_bend') >= 0.0001 ? column('seconds') : NaN):(column('error_bend')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'squeeze.csv' using (strcol('method') eq 'default' && column('error_bend') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000174305 && x <= 0.0255611 ? 9.26124e-06 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of growth (volume)"
  unset key
  plot 'squeeze.csv' using (strcol('method') eq 'consistent' && column('error_growth') >= 0.0001 ? column('seconds') : NaN):(column('error_growth')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'squeeze.csv' using (strcol('method') eq 'consistent' && column('error_growth') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'squeeze.csv' using (strcol('method') eq 'naive' && column('error_growth') >= 0.0001 ? column('seconds') : NaN):(column('error_growth')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'squeeze.csv' using (strcol('method') eq 'naive' && column('error_growth') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'squeeze.csv' using (strcol('method') eq 'consistent in float' && column('error_growth') >= 0.0001 ? column('seconds') : NaN):(column('error_growth')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'squeeze.csv' using (strcol('method') eq 'consistent in float' && column('error_growth') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'squeeze.csv' using (strcol('method') eq 'explicit' && column('error_growth') >= 0.0001 ? column('seconds') : NaN):(column('error_growth')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'squeeze.csv' using (strcol('method') eq 'explicit' && column('error_growth') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'squeeze.csv' using (strcol('method') eq 'default' && column('error_growth') >= 0.0001 ? column('seconds') : NaN):(column('error_growth')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'squeeze.csv' using (strcol('method') eq 'default' && column('error_growth') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000174305 && x <= 0.0255611 ? 7.25997e-06 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of ripple (not fitted)"
  unset key
  plot 'squeeze.csv' using (strcol('method') eq 'consistent' && column('error_ripple') >= 0.0001 ? column('seconds') : NaN):(column('error_ripple')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'squeeze.csv' using (strcol('method') eq 'consistent' && column('error_ripple') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'squeeze.csv' using (strcol('method') eq 'naive' && column('error_ripple') >= 0.0001 ? column('seconds') : NaN):(column('error_ripple')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'squeeze.csv' using (strcol('method') eq 'naive' && column('error_ripple') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'squeeze.csv' using (strcol('method') eq 'consistent in float' && column('error_ripple') >= 0.0001 ? column('seconds') : NaN):(column('error_ripple')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'squeeze.csv' using (strcol('method') eq 'consistent in float' && column('error_ripple') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'squeeze.csv' using (strcol('method') eq 'explicit' && column('error_ripple') >= 0.0001 ? column('seconds') : NaN):(column('error_ripple')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'squeeze.csv' using (strcol('method') eq 'explicit' && column('error_ripple') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'squeeze.csv' using (strcol('method') eq 'default' && column('error_ripple') >= 0.0001 ? column('seconds') : NaN):(column('error_ripple')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'squeeze.csv' using (strcol('method') eq 'default' && column('error_ripple') < 0.0001 ? column('seconds') : NaN):(0.0001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000174305 && x <= 0.0255611 ? 7.26339e-06 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  unset multiplot
  unset output
}
