set xlabel '{{abscissa}}' offset 0,0.4
set ylabel '{{quantity}}' offset 1,0
set key outside top center horizontal maxrows {{key_rows}} samplen 2.4 width 1
set bmargin 2.8
set rmargin 2
set xrange [{{x_from}}:*]
set yrange [0:*]
set offsets 0,0,graph 0.06,0
plot {{curves}}
