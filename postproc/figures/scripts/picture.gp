# Draws {{name}}.svg and {{name}}.png from the CSV files it names: gnuplot {{name}}.gp
{{look}}{{settings}}set terminal svg size {{width}},{{height}} dynamic font 'Helvetica,13' noenhanced
set output '{{name}}.svg'
{{plot}}
set terminal pngcairo size {{png_width}},{{png_height}} font 'sans,13' fontscale 1.9 linewidth 2 pointscale 2 noenhanced
set output '{{name}}.png'
{{plot_again}}
