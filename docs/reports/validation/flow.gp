# Draws flow.png and flow.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot flow.gp  (in this folder)
if (!exists('name')) name = 'flow'
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
  set border 7
  set link x2 via x*37/0.6 inverse x*0.6/37
  set x2tics 10 nomirror out format '%g °C' font ',9' textcolor '#777777'
  set xlabel 'ambient temperature T_a'
  set ylabel 'pup flow (1/s)'
  set yrange [0:*]
  set grid lc '#dddddd'
  set key top left Left reverse
  plot 'flow.csv' using 'ta':'flow_1':(2*column('flow_1_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'lag 1', \
       'flow.csv' using 'ta':'flow_10':(2*column('flow_10_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#009E73' title 'lag 10', \
       'flow.csv' using 'ta':'flow_50':(2*column('flow_50_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#E69F00' title 'lag 50', \
       'flow.csv' using 'ta':'flow_100':(2*column('flow_100_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#D55E00' title 'lag 100'
  unset output
}
