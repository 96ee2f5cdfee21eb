set datafile missing NaN
set xlabel 't  [s]'
set ylabel 'deepest scour  [mm]'
set key outside right top Left reverse
set yrange [0:*]
set offsets 0,0,graph 0.06,0
plot {{curves}}
