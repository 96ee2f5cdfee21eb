# Draws space_time.png from the CSV files it names: gnuplot space_time.gp
{{look}}set terminal pngcairo size 2000,820 font 'sans,13' fontscale 1.9 linewidth 2 noenhanced
set output 'space_time.png'
unset grid
set xrange [{{x_from}}:{{x_to}}]
set yrange [*:*] noextend
set xlabel 'x  [m]' offset 0,0.4
set ylabel 't  [s]' offset 1,0
set cblabel 'bed risen or sunk  [{{unit}}]'
set cbrange [{{lowest}}:{{highest}}]
set palette defined (-1 '#005a50', -0.5 '#5ab4ac', 0 '#f5f5f0', 0.5 '#d8a048', 1 '#54300a')
set style fill solid noborder
set key top left Left reverse samplen 2
plot {{changes}} using (column('x [m]')):(column('time [s]')):(column('x [m]')-{{half}}):(column('x [m]')+{{half}}):(column('from [s]')):(column('to [s]')):({{factor}}*column('change [m]')) with boxxyerror palette notitle, \
     {{front}} using (column('front [m]')):(column('time [s]')) with lines lw 1.6 lc rgb '#1a1a1a' title 'water front'
