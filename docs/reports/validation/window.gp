# Draws window.png and window.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot window.gp  (in this folder)
if (!exists('name')) name = 'window'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 1180,400 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 1180,400 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set multiplot layout 1,3 margins 0.06,0.985,0.15,0.84 spacing 0.075,0
  set border 7
  set link x2 via x*37/0.6 inverse x*0.6/37
  set x2tics 5 nomirror out format '%g °C' font ',9' textcolor '#777777'
  set xlabel 'ambient temperature T_a'
  set xtics 0.1
  set yrange [0:*]
  set grid lc '#dddddd'
  set title 'huddling 1 − A'
  set key bottom left Left reverse
  plot 'window.csv' using (strcol('window') eq '501–1500' ? column('ta') : NaN):'huddling':(2*column('huddling_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#999999' title 'steps 501–1500', \
       'window.csv' using (strcol('window') eq '2501–4000' ? column('ta') : NaN):'huddling':(2*column('huddling_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'steps 2501–4000'
  set title 'pup flow, lag 1 (1/s)'
  unset key
  plot 'window.csv' using (strcol('window') eq '501–1500' ? column('ta') : NaN):'flow':(2*column('flow_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#999999' title 'steps 501–1500', \
       'window.csv' using (strcol('window') eq '2501–4000' ? column('ta') : NaN):'flow':(2*column('flow_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'steps 2501–4000'
  set title 'standard deviation of A'
  unset key
  plot 'window.csv' using (strcol('window') eq '501–1500' ? column('ta') : NaN):'exposed_sd':(2*column('exposed_sd_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#999999' title 'steps 501–1500', \
       'window.csv' using (strcol('window') eq '2501–4000' ? column('ta') : NaN):'exposed_sd':(2*column('exposed_sd_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'steps 2501–4000'
  unset multiplot
  unset output
}
