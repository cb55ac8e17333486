# Draws litter.png and litter.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot litter.gp  (in this folder)
if (!exists('name')) name = 'litter'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 1300,460 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 1300,460 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set logscale xy
  set xlabel 'CPU seconds'
  set grid lc '#dddddd'
  set multiplot layout 1,4 margins 0.05,0.985,0.3,0.92 spacing 0.055,0
  set title 'T_b'
  set ylabel 'size of the error, 95 % interval'
  set key at screen 0.02, screen 0.02 left bottom maxrows 2 Left reverse
  plot 'litter.csv' using (strcol('group') eq 'seeds' ? column('cpu_seconds') : NaN):(column('mean_tb_interval')) with linespoints pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'seeds', \
       'litter.csv' using (strcol('group') eq 'points' ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#D55E00' title 'points', \
       'litter.csv' using (strcol('group') eq 'steps' ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#009E73' title 'steps', \
       'litter.csv' using (strcol('group') eq 'step (naive)' ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#CC79A7' title 'step (naive)', \
       'litter.csv' using (strcol('group') eq 'step (consistent)' ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#E69F00' title 'step (consistent)', \
       'litter.csv' using (strcol('group') eq 'precision' ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#56B4E9' title 'precision', \
       'litter.csv' using (strcol('group') eq 'heat' ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#444444' title 'heat'
  set title 'huddling 1 - A'
  unset ylabel
  unset key
  plot 'litter.csv' using (strcol('group') eq 'seeds' ? column('cpu_seconds') : NaN):(column('huddling_interval')) with linespoints pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'seeds', \
       'litter.csv' using (strcol('group') eq 'points' ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#D55E00' title 'points', \
       'litter.csv' using (strcol('group') eq 'steps' ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#009E73' title 'steps', \
       'litter.csv' using (strcol('group') eq 'step (naive)' ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#CC79A7' title 'step (naive)', \
       'litter.csv' using (strcol('group') eq 'step (consistent)' ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#E69F00' title 'step (consistent)', \
       'litter.csv' using (strcol('group') eq 'precision' ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#56B4E9' title 'precision', \
       'litter.csv' using (strcol('group') eq 'heat' ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#444444' title 'heat'
  set title 'groups'
  unset ylabel
  unset key
  plot 'litter.csv' using (strcol('group') eq 'seeds' ? column('cpu_seconds') : NaN):(column('groups_interval')) with linespoints pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'seeds', \
       'litter.csv' using (strcol('group') eq 'points' ? column('cpu_seconds') : NaN):(abs(column('groups_difference'))):(abs(column('groups_difference'))):(abs(column('groups_difference')) + column('groups_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#D55E00' title 'points', \
       'litter.csv' using (strcol('group') eq 'steps' ? column('cpu_seconds') : NaN):(abs(column('groups_difference'))):(abs(column('groups_difference'))):(abs(column('groups_difference')) + column('groups_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#009E73' title 'steps', \
       'litter.csv' using (strcol('group') eq 'step (naive)' ? column('cpu_seconds') : NaN):(abs(column('groups_difference'))):(abs(column('groups_difference'))):(abs(column('groups_difference')) + column('groups_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#CC79A7' title 'step (naive)', \
       'litter.csv' using (strcol('group') eq 'step (consistent)' ? column('cpu_seconds') : NaN):(abs(column('groups_difference'))):(abs(column('groups_difference'))):(abs(column('groups_difference')) + column('groups_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#E69F00' title 'step (consistent)', \
       'litter.csv' using (strcol('group') eq 'precision' ? column('cpu_seconds') : NaN):(abs(column('groups_difference'))):(abs(column('groups_difference'))):(abs(column('groups_difference')) + column('groups_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#56B4E9' title 'precision', \
       'litter.csv' using (strcol('group') eq 'heat' ? column('cpu_seconds') : NaN):(abs(column('groups_difference'))):(abs(column('groups_difference'))):(abs(column('groups_difference')) + column('groups_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#444444' title 'heat'
  set title 'pup flow'
  unset ylabel
  unset key
  plot 'litter.csv' using (strcol('group') eq 'seeds' ? column('cpu_seconds') : NaN):(column('flow_interval')) with linespoints pt 7 ps 0.6 lw 1.6 lc '#0072B2' title 'seeds', \
       'litter.csv' using (strcol('group') eq 'points' ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference'))):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#D55E00' title 'points', \
       'litter.csv' using (strcol('group') eq 'steps' ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference'))):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#009E73' title 'steps', \
       'litter.csv' using (strcol('group') eq 'step (naive)' ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference'))):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#CC79A7' title 'step (naive)', \
       'litter.csv' using (strcol('group') eq 'step (consistent)' ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference'))):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#E69F00' title 'step (consistent)', \
       'litter.csv' using (strcol('group') eq 'precision' ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference'))):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#56B4E9' title 'precision', \
       'litter.csv' using (strcol('group') eq 'heat' ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference'))):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.7 lc '#444444' title 'heat'
  unset multiplot
  unset output
}
