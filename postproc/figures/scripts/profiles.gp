set xrange [{{x_from}}:{{x_to}}]
set yrange [{{z_from}}:{{z_to}}]
set xlabel 'x  [m]' offset 0,0.4
set ylabel 'z  [{{unit}}]' offset 1,0
set key outside top right horizontal maxrows 1 samplen 2.2 width -4 font ',11.5' textcolor rgb '#333333'
set label 1 't = {{time}} s' at graph 0.985,0.88 right font ',16' front
set lmargin at screen {{left}}
set rmargin at screen {{right}}
set tmargin at screen {{top}}
set bmargin at screen {{bottom}}
{{curve_names}}plot {{curves}}
