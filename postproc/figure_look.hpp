#pragma once

#include <cmath>
#include <initializer_list>

namespace thalweg {

/// What all gnuplot scripts of a report begin with: the files are CSV with headings, the axes are quiet.
inline constexpr const char* figure_look = R"(set encoding utf8
set datafile separator ','
set datafile columnheaders
set border 3 lw 0.8 lc rgb '#555555'
set tics nomirror out scale 0.6 textcolor rgb '#333333'
set grid lc rgb '#e4e4e4' lw 0.6 dt 1
)";

/// A step of 1, 2 or 5 times a power of ten that divides a length into at most `parts`.
inline double tic_step(double length, int parts) {
  const double least = length / parts;
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double multiple : {1.0, 2.0, 5.0}) {
    if (multiple * decade >= least) return multiple * decade;
  }
  return 10 * decade;
}

}  // namespace thalweg
