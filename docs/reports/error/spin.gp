# Draws spin.png and spin.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot spin.gp  (in this folder)
if (!exists('name')) name = 'spin'
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
  set yrange [1e-06:*]
  set logscale xy
  set format '10^{%L}'
  set xlabel 'time on one core, s a model second'
  set grid lt 1 lc rgb '#dddddd'
  set multiplot layout 1,3 margins 0.0641892,0.97,0.4,0.92 spacing 0.0777027,0
  set title "error of angular momentum"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'spin.csv' using (strcol('method') eq 'consistent' && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'spin.csv' using (strcol('method') eq 'consistent' && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'spin.csv' using (strcol('method') eq 'naive' && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'spin.csv' using (strcol('method') eq 'naive' && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'spin.csv' using (strcol('method') eq 'consistent in float' && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'spin.csv' using (strcol('method') eq 'consistent in float' && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'spin.csv' using (strcol('method') eq 'explicit' && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'spin.csv' using (strcol('method') eq 'explicit' && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'spin.csv' using (strcol('method') eq 'default' && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'spin.csv' using (strcol('method') eq 'default' && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000172046 && x <= 0.00652682 ? 6.97023e-07 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error', \
       NaN with points pt 11 lc '#444444' title 'below the edge'
  set title "error of orientation"
  unset key
  plot 'spin.csv' using (strcol('method') eq 'consistent' && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'spin.csv' using (strcol('method') eq 'consistent' && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'spin.csv' using (strcol('method') eq 'naive' && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'spin.csv' using (strcol('method') eq 'naive' && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'spin.csv' using (strcol('method') eq 'consistent in float' && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'spin.csv' using (strcol('method') eq 'consistent in float' && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'spin.csv' using (strcol('method') eq 'explicit' && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'spin.csv' using (strcol('method') eq 'explicit' && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'spin.csv' using (strcol('method') eq 'default' && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'spin.csv' using (strcol('method') eq 'default' && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000172046 && x <= 0.00652682 ? 2.1947e-07 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error', \
       NaN with points pt 11 lc '#444444' title 'below the edge'
  set title "error of orientation against a rigid body's"
  unset key
  plot 'spin.csv' using (strcol('method') eq 'consistent' && column('error_rigid') >= 1e-06 ? column('seconds') : NaN):(column('error_rigid')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'spin.csv' using (strcol('method') eq 'consistent' && column('error_rigid') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'spin.csv' using (strcol('method') eq 'naive' && column('error_rigid') >= 1e-06 ? column('seconds') : NaN):(column('error_rigid')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'spin.csv' using (strcol('method') eq 'naive' && column('error_rigid') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'spin.csv' using (strcol('method') eq 'consistent in float' && column('error_rigid') >= 1e-06 ? column('seconds') : NaN):(column('error_rigid')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'spin.csv' using (strcol('method') eq 'consistent in float' && column('error_rigid') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'spin.csv' using (strcol('method') eq 'explicit' && column('error_rigid') >= 1e-06 ? column('seconds') : NaN):(column('error_rigid')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'spin.csv' using (strcol('method') eq 'explicit' && column('error_rigid') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'spin.csv' using (strcol('method') eq 'default' && column('error_rigid') >= 1e-06 ? column('seconds') : NaN):(column('error_rigid')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'spin.csv' using (strcol('method') eq 'default' && column('error_rigid') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000172046 && x <= 0.00652682 ? 6.74025e-07 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error', \
       NaN with points pt 11 lc '#444444' title 'below the edge'
  unset multiplot
  unset output
}
