# Draws {{name}}.png from the CSV files it names: gnuplot {{name}}.gp
{{look}}set terminal pngcairo size {{width}},{{height}} font 'sans,13' fontscale 1.9 linewidth 2 noenhanced
set output '{{name}}.png'
unset grid
set border 15 lw 0.8 lc rgb '#555555'
{{shape}}set lmargin at screen {{left}}
set rmargin at screen {{right}}
set tmargin at screen {{top}}
set bmargin at screen {{bottom}}
set xrange [{{x_from}}:{{x_to}}] noextend
set yrange [{{y_from}}:{{y_to}}] noextend
set xlabel 'x  [m]' offset 0,0.4
set ylabel 'y  [m]' offset 1,0
set ytics {{y_tics}}
set cblabel '{{quantity}}'
set cbtics {{steps}}
set cbrange [{{lowest}}:{{highest}}]
set palette defined ({{palette}})
set style fill solid noborder
{{labels}}plot {{data}} using (column('x [m]')):(column('y [m]')):(column('x [m]')-{{half}}):(column('x [m]')+{{half}}):(column('y [m]')-{{half}}):(column('y [m]')+{{half}}):({{value}}) with boxxyerror palette notitle, \
     {{data}} using (column('ground [-]')==2 ? column('x [m]') : NaN):(column('y [m]')):(column('x [m]')-{{half}}):(column('x [m]')+{{half}}):(column('y [m]')-{{half}}):(column('y [m]')+{{half}}) with boxxyerror fc rgb '#dcdcdc' notitle, \
     {{data}} using (column('ground [-]')==3 ? column('x [m]') : NaN):(column('y [m]')):(column('x [m]')-{{half}}):(column('x [m]')+{{half}}):(column('y [m]')-{{half}}):(column('y [m]')+{{half}}) with boxxyerror fc rgb '#5a5a5a' notitle{{lines}}
