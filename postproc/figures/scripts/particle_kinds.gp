set key at screen {{right}},{{title_height}} right horizontal samplen 0.6 width 1
plot {{curves}}
unset key
