# Draws steering-points.png and steering-points.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot steering-points.gp  (in this folder)
if (!exists('name')) name = 'steering-points'
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
  plot 'steering-points.csv' using ($0 == 0 && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 7 ps 1.2 lc '#0072B2' title 'k = 3', \
       'steering-points.csv' using ($0 == 0 && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'steering-points.csv' using ($0 == 1 && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 7 ps 1.2 lc '#D55E00' title 'k = 4', \
       'steering-points.csv' using ($0 == 1 && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'steering-points.csv' using ($0 == 2 && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 7 ps 1.2 lc '#009E73' title 'k = 5', \
       'steering-points.csv' using ($0 == 2 && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'steering-points.csv' using ($0 == 3 && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 7 ps 1.2 lc '#CC79A7' title 'k = 7', \
       'steering-points.csv' using ($0 == 3 && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'steering-points.csv' using ($0 == 4 && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 7 ps 1.2 lc '#E69F00' title 'k = 9', \
       'steering-points.csv' using ($0 == 4 && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#E69F00' notitle, \
       'steering-points.csv' using ($0 == 5 && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 7 ps 1.2 lc '#56B4E9' title 'k = 11', \
       'steering-points.csv' using ($0 == 5 && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#56B4E9' notitle, \
       'steering-points.csv' using ($0 == 6 && column('error_path') >= 0.001 ? column('seconds') : NaN):(column('error_path')) with points pt 7 ps 1.2 lc '#444444' title 'k = 15', \
       'steering-points.csv' using ($0 == 6 && column('error_path') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#444444' notitle
  set title "error of course"
  unset key
  plot 'steering-points.csv' using ($0 == 0 && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 7 ps 1.2 lc '#0072B2' title 'k = 3', \
       'steering-points.csv' using ($0 == 0 && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'steering-points.csv' using ($0 == 1 && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 7 ps 1.2 lc '#D55E00' title 'k = 4', \
       'steering-points.csv' using ($0 == 1 && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'steering-points.csv' using ($0 == 2 && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 7 ps 1.2 lc '#009E73' title 'k = 5', \
       'steering-points.csv' using ($0 == 2 && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#009E73' notitle, \
       'steering-points.csv' using ($0 == 3 && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 7 ps 1.2 lc '#CC79A7' title 'k = 7', \
       'steering-points.csv' using ($0 == 3 && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'steering-points.csv' using ($0 == 4 && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 7 ps 1.2 lc '#E69F00' title 'k = 9', \
       'steering-points.csv' using ($0 == 4 && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#E69F00' notitle, \
       'steering-points.csv' using ($0 == 5 && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 7 ps 1.2 lc '#56B4E9' title 'k = 11', \
       'steering-points.csv' using ($0 == 5 && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#56B4E9' notitle, \
       'steering-points.csv' using ($0 == 6 && column('error_course') >= 0.001 ? column('seconds') : NaN):(column('error_course')) with points pt 7 ps 1.2 lc '#444444' title 'k = 15', \
       'steering-points.csv' using ($0 == 6 && column('error_course') < 0.001 ? column('seconds') : NaN):(0.001) with points pt 11 ps 1 lc '#444444' notitle
  unset multiplot
  unset output
}
