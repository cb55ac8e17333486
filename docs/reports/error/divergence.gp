# Draws divergence.png and divergence.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot divergence.gp  (in this folder)
if (!exists('name')) name = 'divergence'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 760,500 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 760,500 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set logscale y
  set format y '10^{%L}'
  set xlabel 'model seconds'
  set ylabel 'distance'
  set grid lc '#dddddd'
  set key bottom right
  plot 'divergence.csv' using (column('seed') == 1 ? column('time') : NaN):(column('distance')) with lines lw 1.6 title 'seed 1', \
       'divergence.csv' using (column('seed') == 2 ? column('time') : NaN):(column('distance')) with lines lw 1.6 title 'seed 2', \
       'divergence.csv' using (column('seed') == 3 ? column('time') : NaN):(column('distance')) with lines lw 1.6 title 'seed 3', \
       'divergence.csv' using (column('seed') == 4 ? column('time') : NaN):(column('distance')) with lines lw 1.6 title 'seed 4', \
       'divergence.csv' using (column('seed') == 5 ? column('time') : NaN):(column('distance')) with lines lw 1.6 title 'seed 5'
  unset output
}
