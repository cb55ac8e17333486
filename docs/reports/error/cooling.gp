# Draws cooling.png and cooling.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot cooling.gp  (in this folder)
if (!exists('name')) name = 'cooling'
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
  set yrange [1e-07:*]
  set logscale xy
  set format '10^{%L}'
  set xlabel 'time on one core, s a model second'
  set grid lt 1 lc rgb '#dddddd'
  set multiplot layout 1,2 margins 0.0931373,0.97,0.4,0.92 spacing 0.112745,0
  set title "error of T_b at k1 = 0.9"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'cooling.csv' using (strcol('method') eq 'Euler' && column('error_cooling') >= 1e-07 ? column('seconds') : NaN):(column('error_cooling')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'Euler', \
       'cooling.csv' using (strcol('method') eq 'Euler' && column('error_cooling') < 1e-07 ? column('seconds') : NaN):(1e-07) with points pt 11 ps 1 lc '#0072B2' notitle, \
       (x >= 7.0211e-05 && x <= 0.0360987 ? 1.02931e-07 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  set title "error of T_b at k1 = 100"
  unset key
  plot 'cooling.csv' using (strcol('method') eq 'Euler' && column('error_fast') >= 1e-07 ? column('seconds') : NaN):(column('error_fast')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'Euler', \
       'cooling.csv' using (strcol('method') eq 'Euler' && column('error_fast') < 1e-07 ? column('seconds') : NaN):(1e-07) with points pt 11 ps 1 lc '#0072B2' notitle, \
       (x >= 7.0211e-05 && x <= 0.0360987 ? 5.17501e-06 / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the error'
  unset multiplot
  unset output
}
