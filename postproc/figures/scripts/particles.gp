# Draws {{name}}.png from the CSV file it names: gnuplot {{name}}.gp
{{look}}set terminal pngcairo size {{width}},{{height}} font 'sans,13' fontscale 2 linewidth 2 noenhanced
set output '{{name}}.png'
set multiplot
unset grid
set size ratio -1
set xrange [{{x_from}}:{{x_to}}]
set yrange [{{z_from}}:{{z_to}}]
set xtics {{x_tics}}
set ytics {{z_tics}}
set lmargin at screen {{left}}
set rmargin at screen {{right}}
{{panels}}unset multiplot
