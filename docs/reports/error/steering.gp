# Draws steering.png and steering.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot steering.gp  (in this folder)
if (!exists('name')) name = 'steering'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 1020,540 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 1020,540 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set yrange [0.001:*]
  set logscale xy
  set format '10^{%L}'
  set xlabel 'time on one core, s a model second'
  set grid lt 1 lc rgb '#dddddd'
  set multiplot layout 1,2 margins 0.0931373,0.97,0.4,0.92 spacing 0.112745,0
  set title "error of path"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'steering.csv' using (strcol('method') eq 'consistent' && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'steering.csv' using (strcol('method') eq 'consistent' && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'steering.csv' using (strcol('method') eq 'naive' && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'steering.csv' using (strcol('method') eq 'naive' && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'steering.csv' using (strcol('method') eq 'consistent in float' && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'steering.csv' using (strcol('method') eq 'consistent in float' && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'steering.csv' using (strcol('method') eq 'explicit' && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'steering.csv' using (strcol('method') eq 'explicit' && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'steering.csv' using (strcol('method') eq 'default' && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'steering.csv' using (strcol('method') eq 'default' && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.00059761 && x <= 0.0116014 ? 0.000735659 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of course"
  unset key
  plot 'steering.csv' using (strcol('method') eq 'consistent' && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'consistent', \
       'steering.csv' using (strcol('method') eq 'consistent' && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'steering.csv' using (strcol('method') eq 'naive' && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'naive', \
       'steering.csv' using (strcol('method') eq 'naive' && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'steering.csv' using (strcol('method') eq 'consistent in float' && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'consistent in float', \
       'steering.csv' using (strcol('method') eq 'consistent in float' && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'steering.csv' using (strcol('method') eq 'explicit' && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#CC79A7' title 'explicit', \
       'steering.csv' using (strcol('method') eq 'explicit' && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'steering.csv' using (strcol('method') eq 'default' && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default', \
       'steering.csv' using (strcol('method') eq 'default' && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#000000' notitle, \
       (x >= 0.00059761 && x <= 0.0116014 ? 0.000143565 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  unset multiplot
  unset output
}
