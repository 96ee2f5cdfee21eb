set xlabel 't  [s]' offset 0,0.4
set ylabel 'energy  [{{unit}}]' offset 1,0
set key outside top center horizontal maxrows 2 samplen 2.4 width 1
set bmargin 2.8
set rmargin 2
plot {{curves}}
