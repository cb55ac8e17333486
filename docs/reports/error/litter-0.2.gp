# Draws litter-0.2.png and litter-0.2.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot litter-0.2.gp  (in this folder)
if (!exists('name')) name = 'litter-0.2'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 1200,520 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 1200,520 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  set logscale xy
  set xlabel 'CPU seconds'
  set format y '%g'
  set grid lt 1 lc rgb '#dddddd'
  set multiplot layout 1,3 margins 0.0792,0.965,0.38,0.93 spacing 0.0625,0
  set title 'huddling' noenhanced
  set ylabel 'size of the change'
  set key at screen 0.02, screen 0.02 left bottom maxrows 5 Left reverse
  plot 'litter-0.2.csv' using (strcol('group') eq 'seeds' ? column('cpu_seconds') : NaN):(column('huddling_interval')) with lines lw 1.6 lc '#444444' title 'interval of the mean, fewer to more seeds', \
       'litter-0.2.csv' using (strcol('group') eq 'time step' && abs(column('huddling_difference')) > column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) - column('huddling_difference_interval')):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#0072B2' title 'time step', \
       'litter-0.2.csv' using (strcol('group') eq 'time step' && abs(column('huddling_difference')) <= column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with points pt 11 ps 0.8 lc '#0072B2' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'points' && abs(column('huddling_difference')) > column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) - column('huddling_difference_interval')):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#D55E00' title 'points', \
       'litter-0.2.csv' using (strcol('group') eq 'points' && abs(column('huddling_difference')) <= column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with points pt 11 ps 0.8 lc '#D55E00' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'precision' && abs(column('huddling_difference')) > column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) - column('huddling_difference_interval')):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#009E73' title 'precision', \
       'litter-0.2.csv' using (strcol('group') eq 'precision' && abs(column('huddling_difference')) <= column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with points pt 11 ps 0.8 lc '#009E73' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'heat' && abs(column('huddling_difference')) > column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) - column('huddling_difference_interval')):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#CC79A7' title 'heat', \
       'litter-0.2.csv' using (strcol('group') eq 'heat' && abs(column('huddling_difference')) <= column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with points pt 11 ps 0.8 lc '#CC79A7' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'run length' && abs(column('huddling_difference')) > column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) - column('huddling_difference_interval')):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#E69F00' title 'run length', \
       'litter-0.2.csv' using (strcol('group') eq 'run length' && abs(column('huddling_difference')) <= column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with points pt 11 ps 0.8 lc '#E69F00' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'window' && abs(column('huddling_difference')) > column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference'))):(abs(column('huddling_difference')) - column('huddling_difference_interval')):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#56B4E9' title 'window', \
       'litter-0.2.csv' using (strcol('group') eq 'window' && abs(column('huddling_difference')) <= column('huddling_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('huddling_difference')) + column('huddling_difference_interval')) with points pt 11 ps 0.8 lc '#56B4E9' notitle, \
       NaN with points pt 11 lc '#444444' title 'upper bound'
  set title 'mean_tb' noenhanced
  unset ylabel
  unset key
  plot 'litter-0.2.csv' using (strcol('group') eq 'seeds' ? column('cpu_seconds') : NaN):(column('mean_tb_interval')) with lines lw 1.6 lc '#444444' title 'interval of the mean, fewer to more seeds', \
       'litter-0.2.csv' using (strcol('group') eq 'time step' && abs(column('mean_tb_difference')) > column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) - column('mean_tb_difference_interval')):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#0072B2' title 'time step', \
       'litter-0.2.csv' using (strcol('group') eq 'time step' && abs(column('mean_tb_difference')) <= column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with points pt 11 ps 0.8 lc '#0072B2' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'points' && abs(column('mean_tb_difference')) > column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) - column('mean_tb_difference_interval')):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#D55E00' title 'points', \
       'litter-0.2.csv' using (strcol('group') eq 'points' && abs(column('mean_tb_difference')) <= column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with points pt 11 ps 0.8 lc '#D55E00' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'precision' && abs(column('mean_tb_difference')) > column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) - column('mean_tb_difference_interval')):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#009E73' title 'precision', \
       'litter-0.2.csv' using (strcol('group') eq 'precision' && abs(column('mean_tb_difference')) <= column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with points pt 11 ps 0.8 lc '#009E73' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'heat' && abs(column('mean_tb_difference')) > column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) - column('mean_tb_difference_interval')):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#CC79A7' title 'heat', \
       'litter-0.2.csv' using (strcol('group') eq 'heat' && abs(column('mean_tb_difference')) <= column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with points pt 11 ps 0.8 lc '#CC79A7' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'run length' && abs(column('mean_tb_difference')) > column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) - column('mean_tb_difference_interval')):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#E69F00' title 'run length', \
       'litter-0.2.csv' using (strcol('group') eq 'run length' && abs(column('mean_tb_difference')) <= column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with points pt 11 ps 0.8 lc '#E69F00' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'window' && abs(column('mean_tb_difference')) > column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference'))):(abs(column('mean_tb_difference')) - column('mean_tb_difference_interval')):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#56B4E9' title 'window', \
       'litter-0.2.csv' using (strcol('group') eq 'window' && abs(column('mean_tb_difference')) <= column('mean_tb_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('mean_tb_difference')) + column('mean_tb_difference_interval')) with points pt 11 ps 0.8 lc '#56B4E9' notitle, \
       NaN with points pt 11 lc '#444444' title 'upper bound'
  set title 'flow' noenhanced
  unset ylabel
  unset key
  plot 'litter-0.2.csv' using (strcol('group') eq 'seeds' ? column('cpu_seconds') : NaN):(column('flow_interval')) with lines lw 1.6 lc '#444444' title 'interval of the mean, fewer to more seeds', \
       'litter-0.2.csv' using (strcol('group') eq 'time step' && abs(column('flow_difference')) > column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference')) - column('flow_difference_interval')):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#0072B2' title 'time step', \
       'litter-0.2.csv' using (strcol('group') eq 'time step' && abs(column('flow_difference')) <= column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference')) + column('flow_difference_interval')) with points pt 11 ps 0.8 lc '#0072B2' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'points' && abs(column('flow_difference')) > column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference')) - column('flow_difference_interval')):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#D55E00' title 'points', \
       'litter-0.2.csv' using (strcol('group') eq 'points' && abs(column('flow_difference')) <= column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference')) + column('flow_difference_interval')) with points pt 11 ps 0.8 lc '#D55E00' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'precision' && abs(column('flow_difference')) > column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference')) - column('flow_difference_interval')):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#009E73' title 'precision', \
       'litter-0.2.csv' using (strcol('group') eq 'precision' && abs(column('flow_difference')) <= column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference')) + column('flow_difference_interval')) with points pt 11 ps 0.8 lc '#009E73' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'heat' && abs(column('flow_difference')) > column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference')) - column('flow_difference_interval')):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#CC79A7' title 'heat', \
       'litter-0.2.csv' using (strcol('group') eq 'heat' && abs(column('flow_difference')) <= column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference')) + column('flow_difference_interval')) with points pt 11 ps 0.8 lc '#CC79A7' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'run length' && abs(column('flow_difference')) > column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference')) - column('flow_difference_interval')):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#E69F00' title 'run length', \
       'litter-0.2.csv' using (strcol('group') eq 'run length' && abs(column('flow_difference')) <= column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference')) + column('flow_difference_interval')) with points pt 11 ps 0.8 lc '#E69F00' notitle, \
       'litter-0.2.csv' using (strcol('group') eq 'window' && abs(column('flow_difference')) > column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference'))):(abs(column('flow_difference')) - column('flow_difference_interval')):(abs(column('flow_difference')) + column('flow_difference_interval')) with yerrorbars pt 7 ps 0.8 lc '#56B4E9' title 'window', \
       'litter-0.2.csv' using (strcol('group') eq 'window' && abs(column('flow_difference')) <= column('flow_difference_interval') ? column('cpu_seconds') : NaN):(abs(column('flow_difference')) + column('flow_difference_interval')) with points pt 11 ps 0.8 lc '#56B4E9' notitle, \
       NaN with points pt 11 lc '#444444' title 'upper bound'
  unset multiplot
  unset output
}
