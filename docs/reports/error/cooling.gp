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
    set terminal pngcairo size 1480,520 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 1480,520 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set yrange [1e-17:*]
  set logscale xy
  set format '10^{%L}'
  set xlabel 'time on one core, s a model second'
  set grid lc '#dddddd'
  set multiplot layout 1,3 margins 0.08,0.97,0.36,0.92 spacing 0.09,0
  set title "error of T_b at k1 = 0.9"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'cooling.csv' using (strcol('method') eq 'exact' ? column('seconds') : NaN):(column('error_cooling') < 1e-17 ? 1e-17 : column('error_cooling')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'exact', \
       'cooling.csv' using (strcol('method') eq 'Euler' ? column('seconds') : NaN):(column('error_cooling') < 1e-17 ? 1e-17 : column('error_cooling')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'Euler', \
       'cooling.csv' using (strcol('method') eq 'exact in float' ? column('seconds') : NaN):(column('error_cooling') < 1e-17 ? 1e-17 : column('error_cooling')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'exact in float', \
       'cooling.csv' using (strcol('method') eq 'default' ? column('seconds') : NaN):(column('error_cooling') < 1e-17 ? 1e-17 : column('error_cooling')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default'
  set title "error of T_b at k1 = 100"
  unset key
  plot 'cooling.csv' using (strcol('method') eq 'exact' ? column('seconds') : NaN):(column('error_fast') < 1e-17 ? 1e-17 : column('error_fast')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'exact', \
       'cooling.csv' using (strcol('method') eq 'Euler' ? column('seconds') : NaN):(column('error_fast') < 1e-17 ? 1e-17 : column('error_fast')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'Euler', \
       'cooling.csv' using (strcol('method') eq 'exact in float' ? column('seconds') : NaN):(column('error_fast') < 1e-17 ? 1e-17 : column('error_fast')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'exact in float', \
       'cooling.csv' using (strcol('method') eq 'default' ? column('seconds') : NaN):(column('error_fast') < 1e-17 ? 1e-17 : column('error_fast')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default'
  set title "error of T_b at k1 = k2 = 10^4"
  unset key
  plot 'cooling.csv' using (strcol('method') eq 'exact' ? column('seconds') : NaN):(column('error_stiff') < 1e-17 ? 1e-17 : column('error_stiff')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#0072B2' title 'exact', \
       'cooling.csv' using (strcol('method') eq 'Euler' ? column('seconds') : NaN):(column('error_stiff') < 1e-17 ? 1e-17 : column('error_stiff')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#D55E00' title 'Euler', \
       'cooling.csv' using (strcol('method') eq 'exact in float' ? column('seconds') : NaN):(column('error_stiff') < 1e-17 ? 1e-17 : column('error_stiff')) with linespoints lw 1.6 pt 7 ps 0.6 lc '#009E73' title 'exact in float', \
       'cooling.csv' using (strcol('method') eq 'default' ? column('seconds') : NaN):(column('error_stiff') < 1e-17 ? 1e-17 : column('error_stiff')) with points pt 6 ps 2.2 lw 2 lc '#000000' title 'default'
  unset multiplot
  unset output
}
