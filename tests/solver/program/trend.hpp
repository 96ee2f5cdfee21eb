#pragma once

#include <cstddef>
#include <vector>

namespace thalweg::test {

/// Slope of the straight line through the points from index `first` on.
inline double trend(const std::vector<double>& t, const std::vector<double>& y, std::size_t first) {
  double n = 0;
  double st = 0;
  double sy = 0;
  double stt = 0;
  double sty = 0;
  for (std::size_t i = first; i < t.size(); ++i) {
    n += 1, st += t[i], sy += y[i], stt += t[i] * t[i], sty += t[i] * y[i];
  }
  return (n * sty - st * sy) / (n * stt - st * st);
}

}  // namespace thalweg::test
