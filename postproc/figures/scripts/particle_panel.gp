unset label
set tmargin at screen {{top}}
set bmargin at screen {{bottom}}
set label 1 'z  [m]' at screen 0.005,{{title_height}} left
{{x_title}}{{content}}
