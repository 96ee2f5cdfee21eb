set title '{{section}}'
set ylabel '{{level_title}}'
set xlabel ''
plot {{levels}}
unset title
set xlabel 't  [s]'
set ylabel '{{error_title}}'
{{plot_errors}}
