#include "foam_reference/library/bed.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace thalweg::foam {

namespace {

std::size_t at(int column) { return static_cast<std::size_t>(column); }

}  // namespace

int BedGrid::neighbour(int column, int axis, bool forward) const {
  int i = column % nx;
  int j = column / nx;
  int& along = axis == 0 ? i : j;
  const int count = axis == 0 ? nx : ny;
  along += forward ? 1 : -1;
  if (along < 0 || along >= count) {
    if (!(axis == 0 ? periodic_x : periodic_y) || count == 1) return -1;
    along = (along + count) % count;
  }
  return j * nx + i;
}

double Bed::level(int column) const {
  const double bulk = packing * area[at(column)];
  return floor[at(column)] + (bulk > 0 ? grains[at(column)] / bulk : 0);
}

int Bed::open_neighbour(int column, int axis, bool forward) const {
  const int next = grid.neighbour(column, axis, forward);
  return next >= 0 && area[at(next)] > 0 ? next : -1;
}

double Bed::slope(int column, int axis) const {
  const int behind = open_neighbour(column, axis, false);
  const int ahead = open_neighbour(column, axis, true);
  const int steps = (behind >= 0 ? 1 : 0) + (ahead >= 0 ? 1 : 0);
  if (steps == 0) return 0;
  return (level(ahead >= 0 ? ahead : column) - level(behind >= 0 ? behind : column)) / (steps * grid.spacing(axis));
}

double Bed::slope_between(int column, int axis, bool forward) const {
  const int next = open_neighbour(column, axis, forward);
  return (level(next) - level(column)) / ((forward ? 1 : -1) * grid.spacing(axis));
}

double Bed::total() const { return std::accumulate(grains.begin(), grains.end(), 0.0); }

void move_bed_load(Bed& bed, const BedLoadSent& sent, double dt) {
  struct Passage {
    int from;
    int to;
    double grains;  // [m^3]
  };
  std::vector<Passage> passages;
  std::vector<double> leaving(bed.grains.size(), 0.0);
  for (int column = 0; column < bed.grid.columns(); ++column) {
    if (bed.grains[at(column)] <= 0) continue;
    for (const int axis : {0, 1}) {
      for (const bool forward : {false, true}) {
        const int to = bed.open_neighbour(column, axis, forward);
        if (to < 0) continue;
        const double width = axis == 0 ? bed.grid.dy : bed.grid.dx;
        const double grains = sent(column, axis, forward) * width * dt;
        if (grains <= 0) continue;
        passages.push_back({column, to, grains});
        leaving[at(column)] += grains;
      }
    }
  }
  const std::vector<double> held = bed.grains;
  for (const Passage& passage : passages) {
    const double share = std::min(1.0, held[at(passage.from)] / leaving[at(passage.from)]);
    bed.grains[at(passage.from)] -= share * passage.grains;
    bed.grains[at(passage.to)] += share * passage.grains;
  }
}

bool avalanche(Bed& bed, double tan_repose, int most_sweeps) {
  const int columns = bed.grid.columns();
  const auto slide = [&](int from, int to, double drop) {
    // Bulk volume that levels the excess, shared by both columns' areas.
    const double bulk = drop / (1 / bed.area[at(from)] + 1 / bed.area[at(to)]);
    const double moved = std::min(bed.packing * bulk, bed.grains[at(from)]);
    bed.grains[at(from)] -= moved;
    bed.grains[at(to)] += moved;
  };
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool at_rest = true;
    for (int column = 0; column < columns; ++column) {
      if (bed.area[at(column)] <= 0) continue;
      for (const int axis : {0, 1}) {
        const int next = bed.open_neighbour(column, axis, true);
        if (next < 0) continue;
        const double spacing = bed.grid.spacing(axis);
        const double difference = bed.level(column) - bed.level(next);
        const double excess = std::fabs(difference) - tan_repose * spacing;
        const int higher = difference > 0 ? column : next;
        if (excess <= 1e-6 * spacing || bed.grains[at(higher)] <= 0) continue;
        slide(higher, difference > 0 ? next : column, excess);
        at_rest = false;
      }
    }
    if (at_rest) return true;
  }
  return false;
}

}  // namespace thalweg::foam
