set multiplot layout 2,3 columnsfirst margins 0.075,0.99,0.14,0.93 spacing 0.05,0.1
set offsets graph 0.08,graph 0.08,graph 0.1,graph 0.1
set key center right
set xtics {{time_tics}}
{{panels}}unset multiplot
