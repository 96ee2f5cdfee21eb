#include "solver/models/surface_bed/make_bed_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "case/bed_on_ground.hpp"
#include "common/error.hpp"
#include "solver/models/surface_bed/arrays.hpp"
#include "solver/models/surface_bed/make_columns_beside.hpp"

namespace thalweg {
namespace {

/// Particles over one place of the ground, from below.
struct Stack {
  std::vector<std::size_t> fluid;
  std::vector<std::size_t> walls;
};

class BedLayer {
 public:
  BedLayer(const Case& of, ParticleSet& particles)
      : case_(of), from_(particles), in_space_(of.info.dimension == 3), spacing_(of.numerics.spacing) {}

  LaidBed lay() {
    stack_up();
    if (stacks_.empty()) throw InputError(case_.file.string() + ": the scene has no fluid, and a bed needs water");
    make_grid();
    for (auto& [site, stack] : stacks_) lay_column(site, stack);
    mark_ends();
    make_particles();
    return std::move(laid_);
  }

 private:
  using Site = std::array<long long, 2>;

  [[nodiscard]] long long period(int axis) const {
    if (!case_.domain.is_periodic(axis)) return 0;
    return std::llround((case_.domain.to[axis] - case_.domain.from[axis]) / spacing_);
  }
  [[nodiscard]] Site site_of(const Vec3& x) const {
    Site site{};
    for (int axis = 0; axis < (in_space_ ? 2 : 1); ++axis) {
      site[axis] = std::llround((x[axis] - node_[axis]) / spacing_);
      const long long around = period(axis);
      if (around > 0) site[axis] = (site[axis] % around + around) % around;
    }
    return site;
  }

  void stack_up() {
    if (from_.info.lattice_node) {
      node_ = *from_.info.lattice_node;
    } else if (from_.size() > 0) {
      node_ = from_.position.front();
    }
    std::map<Site, std::vector<std::size_t>> walls;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const Site site = site_of(from_.position[i]);
      if (from_.type[i] == ParticleType::wall) walls[site].push_back(i);
      if (from_.type[i] == ParticleType::water || from_.type[i] == ParticleType::sediment) {
        stacks_[site].fluid.push_back(i);
      }
    }
    const auto upwards = [&](std::size_t a, std::size_t b) { return from_.position[a].z() < from_.position[b].z(); };
    for (auto& [site, stack] : stacks_) {
      std::sort(stack.fluid.begin(), stack.fluid.end(), upwards);
      const auto found = walls.find(site);
      if (found == walls.end()) continue;
      stack.walls = found->second;
      std::sort(stack.walls.begin(), stack.walls.end(), upwards);
    }
    walls_ = std::move(walls);
  }

  void make_grid() {
    Site low = stacks_.begin()->first;
    Site high = low;
    for (const auto& entry : stacks_) {
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], entry.first[axis]);
        high[axis] = std::max(high[axis], entry.first[axis]);
      }
    }
    BedGrid& grid = laid_.columns.grid;
    for (int axis = 0; axis < 2; ++axis) {
      if (period(axis) == 0) continue;
      low[axis] = 0;
      high[axis] = period(axis) - 1;
      (axis == 0 ? grid.periodic_x : grid.periodic_y) = true;
    }
    low_ = low;
    for (int axis = 0; axis < 2; ++axis) laid_.first[axis] = node_[axis] + spacing_ * static_cast<double>(low[axis]);
    grid.nx = static_cast<int>(high[0] - low[0] + 1);
    grid.ny = static_cast<int>(high[1] - low[1] + 1);
    grid.dx = spacing_;
    grid.dy = in_space_ ? spacing_ : 1;
    const auto columns = static_cast<std::size_t>(grid.columns());
    laid_.columns.packing = 1 - case_.sediment().porosity;
    laid_.columns.area.assign(columns, 0);
    laid_.columns.floor.assign(columns, 0);
    laid_.columns.grains.assign(columns, 0);
    laid_.columns.ceiling.assign(columns, open_sky);
    laid_.rows.assign(columns, 0);
    sediment_.resize(columns);
    place_.assign(from_.size(), BedPlace{});
  }
  [[nodiscard]] int column_of(const Site& site) const {
    const BedGrid& grid = laid_.columns.grid;
    const long long i = site[0] - low_[0];
    const long long j = site[1] - low_[1];
    if (i < 0 || i >= grid.nx || j < 0 || j >= grid.ny) return -1;
    return static_cast<int>(j * grid.nx + i);
  }

  /// The middle of a column over the ground [m]; y = 0 in the plane.
  [[nodiscard]] Vec3 middle_of(int column) const {
    const int row = column / laid_.columns.grid.nx;
    const auto i = static_cast<double>(low_[0] + column % laid_.columns.grid.nx);
    const auto j = static_cast<double>(low_[1] + row);
    return {node_.x() + spacing_ * i, in_space_ ? node_.y() + spacing_ * j : 0, 0};
  }

  void lay_column(const Site& site, const Stack& stack) {
    const auto c = static_cast<std::size_t>(column_of(site));
    GrainColumns& bed = laid_.columns;
    const double lowest = from_.position[stack.fluid.front()].z();
    bed.area[c] = in_space_ ? spacing_ * spacing_ : spacing_;
    bed.floor[c] = lowest - 0.5 * spacing_;
    for (const std::size_t i : stack.fluid) {
      if (from_.type[i] != ParticleType::sediment) continue;
      sediment_[c].push_back(i);
    }
    bed.grains[c] = bed.packing * bed.area[c] * spacing_ * static_cast<double>(sediment_[c].size());
    for (const std::size_t i : stack.walls) {
      const double z = from_.position[i].z();
      place_[i].column = static_cast<float>(c);
      if (std::abs(z - (lowest - spacing_)) < 0.5 * spacing_) place_[i].is_floor = 1;
      if (z > lowest) bed.ceiling[c] = std::min(bed.ceiling[c], z - 0.5 * spacing_);
    }
  }

  /// Walls with no fluid over their place belong to a column beside them, which may cover them.
  void join_walls() {
    for (const auto& [site, members] : walls_) {
      if (stacks_.contains(site)) continue;
      int beside = -1;
      for (const auto& way :
           {Site{1, 0}, Site{-1, 0}, Site{0, 1}, Site{0, -1}, Site{1, 1}, Site{1, -1}, Site{-1, 1}, Site{-1, -1}}) {
        const int column = column_of({site[0] + way[0], site[1] + way[1]});
        if (column < 0 || !(laid_.columns.area[static_cast<std::size_t>(column)] > 0)) continue;
        beside = column;
        break;
      }
      for (const std::size_t i : members) place_[i].column = static_cast<float>(beside);
    }
  }

  /// Columns next to a plane through which water enters or leaves. Those beyond an outlet's plane are no bed.
  void mark_ends() {
    GrainColumns& bed = laid_.columns;
    bed.end.assign(bed.area.size(), BedEnd::closed);
    for (const Outlet& outlet : case_.outlets) {
      const double zone = 4 * case_.smoothing_length();
      for (const int c : beside(outlet, 0, zone)) bed.area[static_cast<std::size_t>(c)] = 0;
      const int axis = axis_of(outlet);
      for (const int c : beside(outlet, -spacing_, 0)) {
        bed.end[static_cast<std::size_t>(c)] = open_end(axis, outlet.axes().flow[axis] > 0);
      }
    }
    if (case_.surface_bed.feed != BedFeed::equilibrium) return;
    for (const Inlet& inlet : case_.inlets) {
      for (const int c : beside(inlet, 0, spacing_)) bed.end[static_cast<std::size_t>(c)] = BedEnd::fed;
    }
  }
  [[nodiscard]] std::vector<int> beside(const Opening& opening, double from, double to) const {
    return columns_beside(opening, case_, laid_.columns.grid, laid_.first, from, to);
  }

  /// The particles but for the sediment, then the rows of the bed. The numbers of the sediment go to the rows, from
  /// above; further rows get new ones.
  void make_particles() {
    join_walls();
    const int spare = rows_in_reach(case_.smoothing_length(), spacing_);
    ParticleSet out;
    out.info = from_.info;
    out.facts = from_.facts;
    std::vector<std::size_t> sources;  // of each new particle; from_.size(): none
    std::vector<BedPlace> places;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      if (from_.type[i] == ParticleType::sediment) continue;
      sources.push_back(i);
      places.push_back(place_[i]);
    }
    const std::size_t others = sources.size();
    for (std::size_t c = 0; c < sediment_.size(); ++c) {
      if (!(laid_.columns.area[c] > 0)) continue;
      const int rows = static_cast<int>(sediment_[c].size()) + spare;
      laid_.rows[c] = static_cast<float>(rows);
      for (int row = 0; row < rows; ++row) {
        const auto known =
            sediment_[c].rbegin() + std::min<std::ptrdiff_t>(row, static_cast<std::ptrdiff_t>(sediment_[c].size()));
        sources.push_back(known == sediment_[c].rend() ? from_.size() : *known);
        BedPlace place;
        place.column = static_cast<float>(c);
        place.row = static_cast<float>(row);
        places.push_back(place);
      }
    }
    copy(sources, out);
    std::vector<double>& numbers = out.doubles[field::bed_place.name];
    std::int64_t next_id = from_.size() == 0 ? 0 : *std::max_element(from_.id.begin(), from_.id.end()) + 1;
    for (std::size_t n = 0; n < sources.size(); ++n) {
      numbers.insert(numbers.end(), {double(places[n].column), double(places[n].row), 0.0, double(places[n].is_floor)});
      if (n < others) continue;
      const auto c = static_cast<std::size_t>(places[n].column);
      const double level = laid_.columns.level(static_cast<int>(c));
      out.type[n] = ParticleType::sediment;
      out.position[n] = middle_of(static_cast<int>(c));
      const double z = level - (double(places[n].row) + 0.5) * spacing_;
      out.position[n].z() = std::max(z, laid_.columns.floor[c] - 0.5 * spacing_);
      if (sources[n] == from_.size()) out.id[n] = next_id++;
    }
    from_ = std::move(out);
  }

  void copy(const std::vector<std::size_t>& sources, ParticleSet& out) const {
    const auto take = [&](const auto& from, auto& to, std::size_t width) {
      if (from.empty()) return;
      to.reserve(sources.size() * width);
      for (const std::size_t source : sources) {
        for (std::size_t k = 0; k < width; ++k) {
          to.push_back(source < from_.size() ? from[source * width + k]
                                             : typename std::remove_reference_t<decltype(to)>::value_type{});
        }
      }
    };
    const auto take_vectors = [&](const auto& from, auto& to) {
      using Vector = typename std::remove_reference_t<decltype(to)>::value_type;
      if (from.empty()) return;
      for (const std::size_t source : sources) {
        to.push_back(source < from_.size() ? from[source] : Vector(Vector::Zero()));
      }
    };
    take(from_.id, out.id, 1);
    take(from_.type, out.type, 1);
    take(from_.state, out.state, 1);
    take(from_.density, out.density, 1);
    take(from_.pressure, out.pressure, 1);
    take(from_.mass, out.mass, 1);
    take(from_.viscosity, out.viscosity, 1);
    take_vectors(from_.position, out.position);
    take_vectors(from_.velocity, out.velocity);
    take_vectors(from_.normal, out.normal);
    for (const auto& [name, values] : from_.scalars) take(values, out.scalars[name], values.size() / from_.size());
    for (const auto& [name, values] : from_.doubles) take(values, out.doubles[name], values.size() / from_.size());
  }

  static constexpr double open_sky = 1e30;  // [m]

  const Case& case_;
  ParticleSet& from_;
  bool in_space_;
  double spacing_;
  Vec3 node_ = Vec3::Zero();
  std::map<Site, Stack> stacks_;
  std::map<Site, std::vector<std::size_t>> walls_;
  Site low_{};
  LaidBed laid_;
  std::vector<std::vector<std::size_t>> sediment_;  // of each column, from below
  std::vector<BedPlace> place_;                     // of each particle of from_
};

}  // namespace

int rows_in_reach(double smoothing_length, double spacing) {
  return static_cast<int>(std::ceil(2 * smoothing_length / spacing)) + 1;
}

LaidBed lay_bed(const Case& of, ParticleSet& particles) {
  require_bed_on_ground(of, particles);
  return BedLayer(of, particles).lay();
}

}  // namespace thalweg
