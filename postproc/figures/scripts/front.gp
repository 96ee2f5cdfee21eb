set xlabel 't  [s]' offset 0,0.4
set ylabel 'x of the water front  [m]' offset 1,0
set key top left reverse Left samplen 2
set bmargin 2.8
set rmargin 2
set xrange [0:*]
set offsets 0,0,graph 0.06,graph 0.06
plot {{curves}}
