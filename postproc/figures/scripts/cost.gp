set logscale xy
set xlabel 'CPU time  [s]' offset 0,0.4
set ylabel 'distance of the {{title}}  [{{unit}}]' offset 1,0
set key top right samplen 2
set bmargin 2.8
set rmargin 2
set offsets graph 0.1,graph 0.1,graph 0.1,graph 0.1
plot {{curves}}
