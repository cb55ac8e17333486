# Draws step_refinement.png and step_refinement.svg from the CSV files in this folder.
# Run it again after editing:  gnuplot step_refinement.gp  (in this folder)
if (!exists('name')) name = 'step_refinement'
set datafile separator ','
set datafile commentschars '#'
set datafile columnheaders
set datafile missing 'nan'
set encoding utf8
set border 3 lc '#444444'
set tics nomirror out textcolor '#222222'
do for [format in 'png svg'] {
  if (format eq 'png') {
    set terminal pngcairo size 980,630 font 'DejaVu Sans,11'
  } else {
    set terminal svg size 980,630 font 'DejaVu Sans,11' background '#ffffff'
  }
  set output name.'.'.format
  file = 'step_refinement.csv'
  colors = '#E6EDF2 #FFE728 #90BBFD #A12511 #20867D #2D436F #C18C09 #9B53E0 #222222 '
  set multiplot
  set samples 400
  unset key
  set border 15 lc '#444444'; set tics front nomirror out
  set tmargin at screen 0.94; set bmargin at screen 0.385
  set logscale x
  set xrange [0.000632456:0.0141421]
  set xtics (0.001, 0.0025, 0.005, 0.01) format '%g'
  unset logscale y
  set yrange [0:1]
  set ytics autofreq format '%g'
  set title 'naive'
  set xlabel 'time step h'
  set ylabel 'rigidity α'
  set lmargin at screen 0.085
  set rmargin at screen 0.495
  unset arrow
  plot for [c=0:8] file using (column('panel') == 0 && column('code') == c ? column('dt') : NaN):'alpha':'x_low':'x_high':'y_low':'y_high' with boxxyerror fs solid 1 noborder lc rgb word(colors, c + 1) notitle, file using (column('panel') == 0 && column('other_code') >= 0 ? sqrt(column('x_low')*column('x_high')) : NaN):((column('y_low')+column('y_high'))/2) with points pt 7 ps 1.25 lc rgb '#ffffff' notitle, file using (column('panel') == 0 && column('other_code') >= 0 ? sqrt(column('x_low')*column('x_high')) : NaN):((column('y_low')+column('y_high'))/2) with points pt 7 ps 1.05 lc rgb '#222222' notitle, for [c=0:8] file using (column('panel') == 0 && column('other_code') == c ? sqrt(column('x_low')*column('x_high')) : NaN):((column('y_low')+column('y_high'))/2) with points pt 7 ps 0.75 lc rgb word(colors, c + 1) notitle, 0.0792 with lines lw 4 lc rgb '#ffffff' notitle, 0.0792 with lines lw 1.6 dt 1 lc rgb '#000000' notitle, '+' using (0.01):(0.7) every ::0::0 with points pt 6 ps 1.7 lw 4 lc rgb '#ffffff' notitle, '+' using (0.01):(0.7) every ::0::0 with points pt 6 ps 1.7 lw 2 lc rgb '#000000' notitle
  set title 'consistent'
  set xlabel 'time step h'
  unset ylabel
  set lmargin at screen 0.565
  set rmargin at screen 0.975
  unset arrow
  plot for [c=0:8] file using (column('panel') == 1 && column('code') == c ? column('dt') : NaN):'alpha':'x_low':'x_high':'y_low':'y_high' with boxxyerror fs solid 1 noborder lc rgb word(colors, c + 1) notitle, file using (column('panel') == 1 && column('other_code') >= 0 ? sqrt(column('x_low')*column('x_high')) : NaN):((column('y_low')+column('y_high'))/2) with points pt 7 ps 1.25 lc rgb '#ffffff' notitle, file using (column('panel') == 1 && column('other_code') >= 0 ? sqrt(column('x_low')*column('x_high')) : NaN):((column('y_low')+column('y_high'))/2) with points pt 7 ps 1.05 lc rgb '#222222' notitle, for [c=0:8] file using (column('panel') == 1 && column('other_code') == c ? sqrt(column('x_low')*column('x_high')) : NaN):((column('y_low')+column('y_high'))/2) with points pt 7 ps 0.75 lc rgb word(colors, c + 1) notitle, '+' using (0.01):(0.7) every ::0::0 with points pt 6 ps 1.7 lw 4 lc rgb '#ffffff' notitle, '+' using (0.01):(0.7) every ::0::0 with points pt 6 ps 1.7 lw 2 lc rgb '#000000' notitle
  unset title; unset border; unset tics; unset xlabel; unset ylabel; unset arrow
  unset logscale; set xrange [0:1]; set yrange [0:1]
  set lmargin at screen 0; set rmargin at screen 1
  set tmargin at screen 0.3; set bmargin at screen 0
  set object rectangle from screen 0.0306122,0.24127 to screen 0.0693878,0.266667 fc rgb '#E6EDF2' fs solid border lc rgb '#888888'
  set label 'stable' at screen 0.0836735,0.253968 left
  set object rectangle from screen 0.336735,0.24127 to screen 0.37551,0.266667 fc rgb '#FFE728' fs solid border lc rgb '#888888'
  set label 'ringing' at screen 0.389796,0.253968 left
  set object rectangle from screen 0.642857,0.24127 to screen 0.681633,0.266667 fc rgb '#90BBFD' fs solid border lc rgb '#888888'
  set label 'overlapping' at screen 0.695918,0.253968 left
  set object rectangle from screen 0.0306122,0.2 to screen 0.0693878,0.225397 fc rgb '#A12511' fs solid border lc rgb '#888888'
  set label 'heating' at screen 0.0836735,0.212698 left
  set object rectangle from screen 0.336735,0.2 to screen 0.37551,0.225397 fc rgb '#20867D' fs solid border lc rgb '#888888'
  set label 'hanging' at screen 0.389796,0.212698 left
  set object rectangle from screen 0.642857,0.2 to screen 0.681633,0.225397 fc rgb '#2D436F' fs solid border lc rgb '#888888'
  set label 'sunk' at screen 0.695918,0.212698 left
  set object rectangle from screen 0.0306122,0.15873 to screen 0.0693878,0.184127 fc rgb '#C18C09' fs solid border lc rgb '#888888'
  set label 'inverted' at screen 0.0836735,0.171429 left
  set object rectangle from screen 0.336735,0.15873 to screen 0.37551,0.184127 fc rgb '#9B53E0' fs solid border lc rgb '#888888'
  set label 'escaped' at screen 0.389796,0.171429 left
  set object rectangle from screen 0.642857,0.15873 to screen 0.681633,0.184127 fc rgb '#222222' fs solid border lc rgb '#888888'
  set label 'diverged' at screen 0.695918,0.171429 left
  set object rectangle from screen 0.0306122,0.11746 to screen 0.0693878,0.142857 fc rgb '#E6EDF2' fs solid border lc rgb '#888888'
  set label '' at screen 0.05,0.130159 point pt 7 ps 1.05 lc rgb '#222222'
  set label '' at screen 0.05,0.130159 point pt 7 ps 0.75 lc rgb '#FFE728'
  set label 'seeds disagree: what others say' at screen 0.0836735,0.130159 left
  set label '' at screen 0.356122,0.130159 point pt 6 ps 1.7 lw 2 lc rgb '#000000'
  set label 'default' at screen 0.389796,0.130159 left
  set object rectangle from screen 0.642857,0.11746 to screen 0.681633,0.142857 fc rgb '#FFFFFF' fs solid border lc rgb '#888888'
  set label 'refused' at screen 0.695918,0.130159 left
  set arrow from screen 0.0306122,0.0888889 to screen 0.0734694,0.0888889 nohead lw 1.6 dt 1 lc rgb '#000000'
  set label 'naive: |λ| = √(1 − α (1 − β)) = 0.98' at screen 0.0836735,0.0888889 left
  plot NaN notitle
  unset object; unset label; unset arrow
  unset multiplot
  unset output
}
