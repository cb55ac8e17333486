# Draws step_gravity.png and step_gravity.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot step_gravity.gp  (in this folder)
if (!exists('name')) name = 'step_gravity'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 980,580 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 980,580 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  file = 'step_gravity.csv'
  colors = '#DCE6EC #F0E442 #56B4E9 #E69F00 #CC5FA0 #333333'
  classes = 'stable ringing interpenetrating inverted escaped diverged'
  set multiplot
  set samples 400
  unset key
  set border 15 lc '#444444'; set tics front nomirror out
  set tmargin at screen 0.92; set bmargin at screen 0.34
  set xlabel 'time step h'
  set logscale x
  set xrange [0.000794301:1.25888]
  set format x '10^{%T}'
  set ylabel 'gravity g'
  set logscale y
  set yrange [0.0681361:146773]
  set format y '10^{%T}'
  set title 'predictive'
  set lmargin at screen 0.08
  set rmargin at screen 0.49
  unset arrow
  set arrow from first 0.666667,graph 0 to first 0.666667,graph 1 nohead front lw 4 lc rgb '#ffffff'
  set arrow from first 0.666667,graph 0 to first 0.666667,graph 1 nohead front lw 1.6 dt 2 lc rgb '#D40000'
  plot for [c=0:5] file using (column('panel') == 0 && column('code') == c ? column('dt') : NaN):'gravity':'x_low':'x_high':'y_low':'y_high' with boxxyerror fs solid 1 noborder lc rgb word(colors, c + 1) notitle, 0.25 / x**2 with lines lw 4 lc rgb '#ffffff' notitle, 0.25 / x**2 with lines lw 1.6 dt 1 lc rgb '#D40000' notitle, '+' using (0.01):(10) every ::0::0 with points pt 7 ps 1.3 lc rgb '#000000' notitle, '+' using (0.01):(10) every ::0::0 with points pt 7 ps 0.8 lc rgb '#ffffff' notitle
  set title 'explicit'
  set lmargin at screen 0.56
  set rmargin at screen 0.97
  unset arrow
  set arrow from first 0.666667,graph 0 to first 0.666667,graph 1 nohead front lw 4 lc rgb '#ffffff'
  set arrow from first 0.666667,graph 0 to first 0.666667,graph 1 nohead front lw 1.6 dt 2 lc rgb '#D40000'
  plot for [c=0:5] file using (column('panel') == 1 && column('code') == c ? column('dt') : NaN):'gravity':'x_low':'x_high':'y_low':'y_high' with boxxyerror fs solid 1 noborder lc rgb word(colors, c + 1) notitle, 0.25 / x**2 with lines lw 4 lc rgb '#ffffff' notitle, 0.25 / x**2 with lines lw 1.6 dt 1 lc rgb '#D40000' notitle, '+' using (0.01):(10) every ::0::0 with points pt 7 ps 1.3 lc rgb '#000000' notitle, '+' using (0.01):(10) every ::0::0 with points pt 7 ps 0.8 lc rgb '#ffffff' notitle
  unset title; unset border; unset tics; unset xlabel; unset ylabel; unset arrow
  unset logscale; set xrange [0:1]; set yrange [0:1]; set lmargin at screen 0.02
  set rmargin at screen 0.98; set tmargin at screen 0.2; set bmargin at screen 0.0
  set key at screen 0.5,0.175 center center horizontal maxrows 1 Left reverse samplen 1.6 width 1
  plot for [c=0:5] NaN with boxes fs solid 1 lc rgb word(colors, c + 1) title word(classes, c + 1)
  set key at screen 0.5,0.065 center center horizontal maxcols 2 Left reverse samplen 3 width 1
  plot NaN with lines lw 1.6 dt 1 lc rgb '#D40000' title 'g h² = r_{pup}: a step falls a radius', NaN with lines lw 1.6 dt 2 lc rgb '#D40000' title 'f h = 2/3: the drive outruns the wall', NaN with points pt 6 ps 1.2 lw 2 lc rgb '#000000' title 'default'
  unset multiplot
  unset output
}
