# Draws readings.png and readings.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot readings.gp  (in this folder)
if (!exists('name')) name = 'readings'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 980,760 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 980,760 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set multiplot layout 2,2 margins 0.09,0.975,0.1,0.92 spacing 0.11,0.18
  set border 7
  set link x2 via x*37/0.6 inverse x*0.6/37
  set x2tics 10 nomirror out format '%g °C' font ',9' textcolor '#777777'
  set xlabel 'ambient temperature T_a'
  set xrange [0:1]
  set yrange [0:*]
  set grid lc '#dddddd'
  set title 'mean T_b − T_a'
  set key top right Left reverse samplen 2
  plot 'readings.csv' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'tb_above_ta':(2*column('mean_tb_se')) with yerrorbars pt 7 ps 0.5 lc '#0072B2' notitle, '' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'tb_above_ta' with lines lw 1.6 lc '#0072B2' title 'nearest', \
       'readings.csv' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'tb_above_ta':(2*column('mean_tb_se')) with yerrorbars pt 7 ps 0.5 lc '#E69F00' notitle, '' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'tb_above_ta' with lines lw 1.6 lc '#E69F00' title 'mean', \
       'readings.csv' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'tb_above_ta':(2*column('mean_tb_se')) with yerrorbars pt 7 ps 0.5 lc '#444444' notitle, '' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'tb_above_ta' with lines lw 1.6 lc '#444444' title 'sum'
  set title 'huddling 1 − A'
  unset key
  plot 'readings.csv' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'huddling':(2*column('huddling_se')) with yerrorbars pt 7 ps 0.5 lc '#0072B2' notitle, '' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'huddling' with lines lw 1.6 lc '#0072B2' title 'nearest', \
       'readings.csv' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'huddling':(2*column('huddling_se')) with yerrorbars pt 7 ps 0.5 lc '#E69F00' notitle, '' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'huddling' with lines lw 1.6 lc '#E69F00' title 'mean', \
       'readings.csv' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'huddling':(2*column('huddling_se')) with yerrorbars pt 7 ps 0.5 lc '#444444' notitle, '' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'huddling' with lines lw 1.6 lc '#444444' title 'sum'
  set title 'groups'
  unset key
  plot 'readings.csv' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'groups':(2*column('groups_se')) with yerrorbars pt 7 ps 0.5 lc '#0072B2' notitle, '' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'groups' with lines lw 1.6 lc '#0072B2' title 'nearest', \
       'readings.csv' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'groups':(2*column('groups_se')) with yerrorbars pt 7 ps 0.5 lc '#E69F00' notitle, '' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'groups' with lines lw 1.6 lc '#E69F00' title 'mean', \
       'readings.csv' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'groups':(2*column('groups_se')) with yerrorbars pt 7 ps 0.5 lc '#444444' notitle, '' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'groups' with lines lw 1.6 lc '#444444' title 'sum'
  set title 'standard deviation of A'
  unset key
  plot 'readings.csv' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'exposed_sd':(2*column('exposed_sd_se')) with yerrorbars pt 7 ps 0.5 lc '#0072B2' notitle, '' using (strcol('reading') eq 'nearest' ? column('ta') : NaN):'exposed_sd' with lines lw 1.6 lc '#0072B2' title 'nearest', \
       'readings.csv' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'exposed_sd':(2*column('exposed_sd_se')) with yerrorbars pt 7 ps 0.5 lc '#E69F00' notitle, '' using (strcol('reading') eq 'mean' ? column('ta') : NaN):'exposed_sd' with lines lw 1.6 lc '#E69F00' title 'mean', \
       'readings.csv' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'exposed_sd':(2*column('exposed_sd_se')) with yerrorbars pt 7 ps 0.5 lc '#444444' notitle, '' using (strcol('reading') eq 'sum' ? column('ta') : NaN):'exposed_sd' with lines lw 1.6 lc '#444444' title 'sum'
  unset multiplot
  unset output
}
