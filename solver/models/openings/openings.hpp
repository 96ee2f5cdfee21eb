#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/particles.hpp"
#include "solver/domain/population.hpp"
#include "solver/models/openings/zone.hpp"
#include "solver/state/report.hpp"

namespace thalweg {

/// The scene's water next to an opening that stands upright.
struct WaterAtOpening {
  double depth = 0;     // [m] over its lower edge
  double level = 0;     // [m] z of the surface under which the mean pressure is hydrostatic
  double bed_load = 0;  // [m^2/s] volume of grains per time and width, at inlets that bring bed load
};

/// The openings of a scene as the host keeps them: who enters where and when. Made from a case (make_openings.hpp); the
/// steps know it through this.
class Openings {
 public:
  virtual ~Openings() = default;

  /// Inlets, then outlets, in the order of the case.
  [[nodiscard]] virtual const std::vector<Zone>& zones() const = 0;
  /// z of the water's surface at each [m]; means nothing at full inlets and falls.
  [[nodiscard]] virtual const std::vector<double>& levels() const = 0;
  /// Volume per time that each takes as a pump [m^3/s] (2-D: [m^2/s]); 0 of others.
  [[nodiscard]] virtual const std::vector<double>& takes() const = 0;
  /// Speed of every column of the inlets [m/s]; dry_column where no water enters.
  [[nodiscard]] virtual const std::vector<float>& speeds() const = 0;

  /// Speed of the bed load of each inlet [m/s]; 0 without.
  [[nodiscard]] virtual const std::vector<double>& feeds() const = 0;

  /// Chooses the columns that water fills at a time [s], and bears the particles of those that become full. waters: next
  /// to each opening. Lists have to be made anew next.
  virtual void fill(double time, const std::vector<WaterAtOpening>& waters, Population& population) = 0;
  /// Speeds and levels at a time [s]. True if they have changed.
  virtual bool set_time(double time) = 0;
  /// Shear stress on a bed that is a surface, where an inlet's water meets it [Pa]: as many grains come in as such a bed
  /// holds. 0, and without a call: that of the inlet's own profile. inlet: its number in the case.
  virtual void set_bed_stress(std::size_t inlet, double stress) = 0;
  /// After a step of dt [s]: bears who follows those that have crossed a plane.
  virtual void advance(double dt, Population& population) = 0;

  /// Counts what has left through an opening [kg]; an inlet's columns that fall dry leave too.
  virtual void count_out(std::size_t opening, double water, double sediment, double grains) = 0;
  [[nodiscard]] virtual std::vector<OpeningFlux> fluxes() const = 0;

  /// All that a checkpoint needs, and back; restored() is false where the numbers are not those of these openings.
  [[nodiscard]] virtual std::vector<double> numbers() const = 0;
  [[nodiscard]] virtual bool restored(const std::vector<double>& numbers) = 0;
};

/// Name of the openings' numbers in a checkpoint (ParticleSet::facts).
inline constexpr const char* openings_fact = "Openings";

}  // namespace thalweg
