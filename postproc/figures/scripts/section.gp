set xrange [{{from}}:{{to}}]
set yrange [{{z_from}}:{{z_to}}]
set xlabel '{{abscissa}}  [m]' offset 0,0.4
set ylabel 'z  [{{unit}}]' offset 1,0
set key outside top right horizontal maxrows 1 samplen 2.2 width -4 textcolor rgb '#333333'
set label 1 '{{place}}' at graph 0.0,1.09 left
set arrow 1 from {{deepest}},{{level_before}} to {{deepest}},{{level_now}} head filled size graph 0.006,20 lw 1.2 lc rgb '#a33b00' front
set lmargin 9
set rmargin 2
set tmargin 2.4
set bmargin 2.8
plot {{curves}}
