#include "solver/models/openings/make_bed_feeds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "case/models/openings.hpp"
#include "common/particles.hpp"

namespace thalweg {
namespace {

/// Time over which the bed load behind an inlet, and what comes back from the outlets, is a mean [s].
constexpr double averaging_time = 0.5;

}  // namespace

BedFeeds::BedFeeds(const Case& of)
    : spacing_(of.numerics.spacing),
      dimension_(of.info.dimension),
      layers_(static_cast<int>(std::floor(zone_length(of) / of.numerics.spacing))) {
  const auto feeds = [](const Inlet& inlet) { return inlet.bed_load != InletBedLoad::none; };
  if (std::none_of(of.inlets.begin(), of.inlets.end(), feeds)) return;
  density_ = of.sediment().bed_density();
  layer_ = (1 - of.sediment().porosity) * spacing_;
  mass_ = density_ * std::pow(spacing_, dimension_);
}

void BedFeeds::add(const Inlet& inlet, const Zone& zone) {
  Row row;
  row.zone = zone;
  row.kind = inlet.bed_load;
  row.asked = inlet.bed_load_rate;
  row.ranks = zone.ranks;
  row.way = 0.5 * spacing_;
  rows_.push_back(row);
  speeds_.push_back(0);
}

void BedFeeds::set_speeds(const std::vector<WaterAtOpening>& waters, const std::vector<double>& sediment, double dt) {
  const double gone = std::max(0.0, -std::accumulate(sediment.begin(), sediment.end(), 0.0));
  const auto returning =
      std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.kind == InletBedLoad::recirculated; });
  for (std::size_t n = 0; n < rows_.size(); ++n) {
    Row& row = rows_[n];
    row.age = std::min(averaging_time, row.age + dt);
    switch (row.kind) {
      case InletBedLoad::none:
        break;
      case InletBedLoad::fixed:
        row.rate = row.asked;
        break;
      case InletBedLoad::equilibrium:
        if (row.age > 0) row.rate += std::min(1.0, dt / row.age) * (std::max(0.0, waters[n].bed_load) - row.rate);
        break;
      case InletBedLoad::recirculated: {
        const double width = 2 * row.zone.half_across;
        const double volume = gone / mass_ * layer_ * std::pow(spacing_, dimension_ - 1);
        row.rate = volume / (averaging_time * width * static_cast<double>(returning));
        break;
      }
    }
    speeds_[n] = row.kind == InletBedLoad::none ? 0 : row.rate / layer_;
  }
}

void BedFeeds::fill(Population& population) {
  if (is_filled_) return;
  is_filled_ = true;
  for (const Row& row : rows_) {
    if (row.kind == InletBedLoad::none) continue;
    for (int layer = 0; layer < layers_; ++layer) bear(row, layer, population);
  }
}

double BedFeeds::advance(std::size_t n, double dt, Population& population) {
  Row& row = rows_[n];
  if (row.kind == InletBedLoad::none) return 0;
  double crossed = 0;
  row.way += dt * double(static_cast<float>(speeds_[n]));  // as the device moves it
  for (; row.way >= spacing_; crossed += mass_ * static_cast<double>(row.ranks)) {
    row.way -= spacing_;
    bear(row, layers_ - 1, population);
  }
  return crossed;
}

void BedFeeds::bear(const Row& row, int layer, Population& population) const {
  const Zone& zone = row.zone;
  for (Index rank = 0; rank < row.ranks; ++rank) {
    const double along = row.way - (layer + 1) * spacing_;
    const double up = -zone.half_up - 0.5 * spacing_;
    const double wide = 2 * zone.half_across / row.ranks;
    const double across = dimension_ == 3 ? (rank + 0.5) * wide - zone.half_across : 0;
    Newborn newborn;
    for (int c = 0; c < 3; ++c) {
      newborn.position.x[c] = zone.at[c] + along * zone.flow[c] + up * zone.up[c] + across * zone.across[c];
    }
    newborn.mass = static_cast<float>(mass_);
    newborn.kind = kind::bed_load;
    newborn.type = static_cast<std::uint8_t>(ParticleType::sediment);
    newborn.role = Role::prescribed;
    population.bear(newborn);
  }
}

void BedFeeds::add_numbers(std::vector<double>& to) const {
  for (const Row& row : rows_) {
    if (row.kind != InletBedLoad::none) to.insert(to.end(), {row.rate, row.age, row.way});
  }
}

std::size_t BedFeeds::count_of_numbers() const {
  return 3 * static_cast<std::size_t>(std::count_if(rows_.begin(), rows_.end(),
                                                    [](const Row& row) { return row.kind != InletBedLoad::none; }));
}

void BedFeeds::restore(const double*& next) {
  is_filled_ = true;
  for (std::size_t n = 0; n < rows_.size(); ++n) {
    Row& row = rows_[n];
    if (row.kind == InletBedLoad::none) continue;
    row.rate = *next++;
    row.age = *next++;
    row.way = *next++;
    speeds_[n] = row.rate / layer_;
  }
}

}  // namespace thalweg
