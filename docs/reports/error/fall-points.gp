# Draws fall-points.png and fall-points.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot fall-points.gp  (in this folder)
if (!exists('name')) name = 'fall-points'
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
  set yrange [1e-06:*]
  set logscale xy
  set format '10^{%L}'
  set xlabel 'time on one core, s a model second'
  set grid lt 1 lc rgb '#dddddd'
  set multiplot layout 1,2 margins 0.0931373,0.97,0.4,0.92 spacing 0.112745,0
  set title "error of height"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'fall-points.csv' using ($0 == 0 && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 7 ps 1.2 lc '#0072B2' title 'k = 3', \
       'fall-points.csv' using ($0 == 0 && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'fall-points.csv' using ($0 == 1 && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 7 ps 1.2 lc '#D55E00' title 'k = 4', \
       'fall-points.csv' using ($0 == 1 && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'fall-points.csv' using ($0 == 2 && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 7 ps 1.2 lc '#009E73' title 'k = 5', \
       'fall-points.csv' using ($0 == 2 && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'fall-points.csv' using ($0 == 3 && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 7 ps 1.2 lc '#CC79A7' title 'k = 7', \
       'fall-points.csv' using ($0 == 3 && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'fall-points.csv' using ($0 == 4 && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 7 ps 1.2 lc '#E69F00' title 'k = 9', \
       'fall-points.csv' using ($0 == 4 && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#E69F00' notitle, \
       'fall-points.csv' using ($0 == 5 && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 7 ps 1.2 lc '#56B4E9' title 'k = 11', \
       'fall-points.csv' using ($0 == 5 && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#56B4E9' notitle, \
       'fall-points.csv' using ($0 == 6 && column('error_height') >= 1e-06 ? column('seconds') : NaN):(column('error_height')) with points pt 7 ps 1.2 lc '#444444' title 'k = 15', \
       'fall-points.csv' using ($0 == 6 && column('error_height') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#444444' notitle
  set title "error of strain"
  unset key
  plot 'fall-points.csv' using ($0 == 0 && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 7 ps 1.2 lc '#0072B2' title 'k = 3', \
       'fall-points.csv' using ($0 == 0 && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'fall-points.csv' using ($0 == 1 && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 7 ps 1.2 lc '#D55E00' title 'k = 4', \
       'fall-points.csv' using ($0 == 1 && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'fall-points.csv' using ($0 == 2 && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 7 ps 1.2 lc '#009E73' title 'k = 5', \
       'fall-points.csv' using ($0 == 2 && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'fall-points.csv' using ($0 == 3 && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 7 ps 1.2 lc '#CC79A7' title 'k = 7', \
       'fall-points.csv' using ($0 == 3 && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'fall-points.csv' using ($0 == 4 && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 7 ps 1.2 lc '#E69F00' title 'k = 9', \
       'fall-points.csv' using ($0 == 4 && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#E69F00' notitle, \
       'fall-points.csv' using ($0 == 5 && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 7 ps 1.2 lc '#56B4E9' title 'k = 11', \
       'fall-points.csv' using ($0 == 5 && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#56B4E9' notitle, \
       'fall-points.csv' using ($0 == 6 && column('error_strain') >= 1e-06 ? column('seconds') : NaN):(column('error_strain')) with points pt 7 ps 1.2 lc '#444444' title 'k = 15', \
       'fall-points.csv' using ($0 == 6 && column('error_strain') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#444444' notitle
  unset multiplot
  unset output
}
