set encoding utf8
set datafile separator ','
set datafile columnheaders
set border 3 lw 0.8 lc rgb '#555555'
set tics nomirror out scale 0.6 textcolor rgb '#333333'
set grid lc rgb '#e4e4e4' lw 0.6 dt 1
