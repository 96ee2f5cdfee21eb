"""Pictures drawn by gnuplot."""

import subprocess


def draw(script, picture, width, height):
    """Draws an SVG of this size [pixels]; the script is kept beside it."""
    head = f'set terminal svg size {width},{height} font "sans,13" background "white"\nset output "{picture.name}"\n'
    file = picture.with_suffix(".gnuplot")
    file.write_text(head + script, encoding="utf-8")
    result = subprocess.run(["gnuplot", file.name], cwd=picture.parent, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"gnuplot: {result.stderr}")
