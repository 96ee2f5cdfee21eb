set xlabel 'velocity  [m/s]' offset 0,0.4
set ylabel 'height over the ground  [{{unit}}]' offset 1,0
set key outside top center horizontal maxrows 2 samplen 2.4 width 1
set bmargin 2.8
set rmargin 2
set xrange [0:*]
set yrange [0:*]
plot {{curves}}
