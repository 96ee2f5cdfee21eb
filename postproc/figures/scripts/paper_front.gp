set datafile missing NaN
set logscale x 2
set xtics ({{spacings}})
set xrange [{{finest}}:{{coarsest}}]
set xlabel 'dp  [mm]'
set ylabel 'x of the water front  [m]'
set key outside right top Left reverse
plot {{curves}}
