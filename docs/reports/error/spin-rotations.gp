# Draws spin-rotations.png and spin-rotations.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot spin-rotations.gp  (in this folder)
if (!exists('name')) name = 'spin-rotations'
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
  set title "error of angular momentum"
  set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse
  plot 'spin-rotations.csv' using ($0 == 0 && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with points pt 7 ps 1.2 lc '#0072B2' title 'Newton (default)', \
       'spin-rotations.csv' using ($0 == 0 && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'spin-rotations.csv' using ($0 == 1 && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with points pt 7 ps 1.2 lc '#D55E00' title 'closed form', \
       'spin-rotations.csv' using ($0 == 1 && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'spin-rotations.csv' using ($0 == 2 && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with points pt 7 ps 1.2 lc '#009E73' title 'Horn''s quaternion', \
       'spin-rotations.csv' using ($0 == 2 && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'spin-rotations.csv' using ($0 == 3 && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with points pt 7 ps 1.2 lc '#CC79A7' title 'Müller 2016, 1 iteration', \
       'spin-rotations.csv' using ($0 == 3 && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'spin-rotations.csv' using ($0 == 4 && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with points pt 7 ps 1.2 lc '#E69F00' title 'Müller 2016, 3 iterations', \
       'spin-rotations.csv' using ($0 == 4 && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#E69F00' notitle, \
       'spin-rotations.csv' using ($0 == 5 && column('error_momentum') >= 1e-06 ? column('seconds') : NaN):(column('error_momentum')) with points pt 7 ps 1.2 lc '#56B4E9' title 'Müller 2016, 5 iterations', \
       'spin-rotations.csv' using ($0 == 5 && column('error_momentum') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#56B4E9' notitle, \
       NaN with points pt 11 lc '#444444' title 'below the edge'
  set title "error of orientation"
  unset key
  plot 'spin-rotations.csv' using ($0 == 0 && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with points pt 7 ps 1.2 lc '#0072B2' title 'Newton (default)', \
       'spin-rotations.csv' using ($0 == 0 && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#0072B2' notitle, \
       'spin-rotations.csv' using ($0 == 1 && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with points pt 7 ps 1.2 lc '#D55E00' title 'closed form', \
       'spin-rotations.csv' using ($0 == 1 && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#D55E00' notitle, \
       'spin-rotations.csv' using ($0 == 2 && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with points pt 7 ps 1.2 lc '#009E73' title 'Horn''s quaternion', \
       'spin-rotations.csv' using ($0 == 2 && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#009E73' notitle, \
       'spin-rotations.csv' using ($0 == 3 && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with points pt 7 ps 1.2 lc '#CC79A7' title 'Müller 2016, 1 iteration', \
       'spin-rotations.csv' using ($0 == 3 && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#CC79A7' notitle, \
       'spin-rotations.csv' using ($0 == 4 && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with points pt 7 ps 1.2 lc '#E69F00' title 'Müller 2016, 3 iterations', \
       'spin-rotations.csv' using ($0 == 4 && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#E69F00' notitle, \
       'spin-rotations.csv' using ($0 == 5 && column('error_orientation') >= 1e-06 ? column('seconds') : NaN):(column('error_orientation')) with points pt 7 ps 1.2 lc '#56B4E9' title 'Müller 2016, 5 iterations', \
       'spin-rotations.csv' using ($0 == 5 && column('error_orientation') < 1e-06 ? column('seconds') : NaN):(1e-06) with points pt 11 ps 1 lc '#56B4E9' notitle, \
       NaN with points pt 11 lc '#444444' title 'below the edge'
  unset multiplot
  unset output
}
