# Draws fall.png and fall.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot fall.gp  (in this folder)
if (!exists('name')) name = 'fall'
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
  set title "error of depth fallen before landing"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'fall.csv' using (strcol('method') eq 'consistent' && column('error_fall') >= 1e-06 ? column('seconds') : NaN):(column('error_fall')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'fall.csv' using (strcol('method') eq 'consistent' && column('error_fall') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'fall.csv' using (strcol('method') eq 'naive' && column('error_fall') >= 1e-06 ? column('seconds') : NaN):(column('error_fall')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'fall.csv' using (strcol('method') eq 'naive' && column('error_fall') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'fall.csv' using (strcol('method') eq 'consistent in float' && column('error_fall') >= 1e-06 ? column('seconds') : NaN):(column('error_fall')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'fall.csv' using (strcol('method') eq 'consistent in float' && column('error_fall') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'fall.csv' using (strcol('method') eq 'explicit' && column('error_fall') >= 1e-06 ? column('seconds') : NaN):(column('error_fall')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'fall.csv' using (strcol('method') eq 'explicit' && column('error_fall') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'fall.csv' using (strcol('method') eq 'default' && column('error_fall') >= 1e-06 ? column('seconds') : NaN):(column('error_fall')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'fall.csv' using (strcol('method') eq 'default' && column('error_fall') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000175963 && x <= 0.00648638 ? 6.29217e-06 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of height"
  unset key
  plot 'fall.csv' using (strcol('method') eq 'consistent' && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'fall.csv' using (strcol('method') eq 'consistent' && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'fall.csv' using (strcol('method') eq 'naive' && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'fall.csv' using (strcol('method') eq 'naive' && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'fall.csv' using (strcol('method') eq 'consistent in float' && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'fall.csv' using (strcol('method') eq 'consistent in float' && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'fall.csv' using (strcol('method') eq 'explicit' && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'fall.csv' using (strcol('method') eq 'explicit' && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'fall.csv' using (strcol('method') eq 'default' && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'fall.csv' using (strcol('method') eq 'default' && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000175963 && x <= 0.00648638 ? 2.01837e-06 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of strain"
  unset key
  plot 'fall.csv' using (strcol('method') eq 'consistent' && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'fall.csv' using (strcol('method') eq 'consistent' && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'fall.csv' using (strcol('method') eq 'naive' && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'fall.csv' using (strcol('method') eq 'naive' && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'fall.csv' using (strcol('method') eq 'consistent in float' && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'fall.csv' using (strcol('method') eq 'consistent in float' && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'fall.csv' using (strcol('method') eq 'explicit' && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'fall.csv' using (strcol('method') eq 'explicit' && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'fall.csv' using (strcol('method') eq 'default' && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'fall.csv' using (strcol('method') eq 'default' && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.000175963 && x <= 0.00648638 ? 1.04139e-05 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  unset multiplot
  unset output
}
