set palette defined ({{palette}})
set cbrange [0:{{largest}}]
set cbtics scale 0.4 {{tics}}
set colorbox user origin 0.93,{{bottom}} size 0.008,{{height}}
set label 3 '{{column}}' at screen {{right}},{{title_height}} right
plot {{table}} using (column('x [m]')):(column('z [m]')):(column('{{column}}')) with points pt 7 ps {{point}} palette notitle
