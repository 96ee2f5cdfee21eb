set xrange [{{x_from}}:{{x_to}}]
set yrange [{{z_from}}:{{z_to}}]
set xlabel 'x  [m]' offset 0,0.4
set ylabel 'z  [{{unit}}]' offset 1,0
set key outside top right horizontal maxrows 1 samplen 2.2
set label 1 't = {{time}} s' at graph 0.985,0.88 right font ',16' front
set lmargin 8
set rmargin 2
set tmargin 2
set bmargin 2.8
plot {{curves}}
