#include "common/app/scour/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/error.hpp"
#include "common/units.hpp"

namespace thalweg {

const std::vector<QuantityKind>& quantity_kinds() {
  static const std::vector<QuantityKind> kinds{
      {"depth", "m", 0, 1e3, true, "Depth of the flow before scour"},
      {"velocity", "m/s", 0, 100, true, "Mean velocity of the flow over the depth"},
      {"discharge", "m^2/s", 0, 1e4, true, "Discharge per width of the flow"},
      {"slope", "", 0, 0.2, true, "Slope of a uniform flow"},
      {"grain", "m", 1e-6, 2, true, "Median grain diameter d50"},
      {"grain-90", "m", 1e-6, 5, true, "Grain diameter d90; default: d50"},
      {"grain-density", "kg/m^3", 1001, 3e4, true, "Density of the grains; default: quartz, 2650 kg/m^3"},
      {"water-density", "kg/m^3", 1, 2e4, true, "Density of the water; default: 1000 kg/m^3"},
      {"viscosity", "Pa s", 1e-6, 1e3, true, "Dynamic viscosity of the water; default: 0.001 Pa s"},
      {"gravity", "m/s^2", 0, 100, true, "Gravity; default: 9.81 m/s^2"},
      {"friction-velocity", "m/s", 0, 10, true, "Friction velocity on the bed; default: by the logarithmic law"},
      {"critical-velocity", "m/s", 0, 100, true, "Mean velocity at which the bed begins to move; default: by a law"},
      {"critical-shields", "", 0, 1, true, "Shields number at which the bed begins to move; default: by a law"},
      {"settling-velocity", "m/s", 0, 10, true, "Settling velocity of a grain; default: by a law"},
      {"pier-width", "m", 0, 1e3, true, "Width of a pier across its axis"},
      {"pier-length", "m", 0, 1e3, true, "Length of a pier along its axis; default: its width"},
      {"pier-angle", "rad", 0, 1.5707963267948966, false, "Angle between flow and pier, \"10 deg\"; default: 0"},
      {"bed-factor", "", 1, 1.5, true, "K3 of HEC-18 for the bed's forms; default: 1.1, up to small dunes"},
      {"width", "m", 0, 1e5, true, "Width of the bed upstream of a contraction"},
      {"contracted-width", "m", 0, 1e5, true, "Width of the bed in a contraction"},
      {"contracted-depth", "m", 0, 1e3, true, "Depth in a contraction before scour; default: that upstream"},
      {"flow-ratio", "", 0, 100, true,
       "Discharge in a contraction over that above the moving bed upstream; default: 1"},
      {"jet-opening", "m", 0, 100, true, "Height of the opening of a wall jet"},
      {"jet-velocity", "m/s", 0, 200, true, "Velocity of a wall jet in its opening"},
      {"apron", "m", 0, 1e4, false, "Length of the rigid apron between an opening and the bed"},
      {"tailwater", "m", 0, 1e3, true, "Depth of the tailwater over the bed; default: the depth"},
      {"turbulence", "", 0, 1, false, "Turbulence intensity r0 at the end of a bed protection"},
      {"time", "s", 0, 1e12, true, "Time since the scour began, \"2 h\", for the depth by Breusers"},
      {"drop", "m", 0, 1e4, true, "Fall of the water, from its level above to the tailwater's"},
      {"pipe-diameter", "m", 0, 100, true, "Diameter of a pipe across the flow"},
      {"pipe-gap", "m", -100, 100, false, "Gap between pipe and bed; negative: buried; default: 0"},
  };
  return kinds;
}

const QuantityKind& quantity_kind(std::string_view name) {
  const auto& kinds = quantity_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const QuantityKind& kind) { return kind.name == name; });
  if (found == kinds.end()) throw std::logic_error(fmt::format("there is no quantity {}", name));
  return *found;
}

namespace {

double parse_number(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, status] = std::from_chars(text.data(), end, value);
  if (status != std::errc{} || stopped != end || !std::isfinite(value))
    throw std::invalid_argument(fmt::format("\"{}\" is not a plain number; write one such as 0.1", text));
  return value;
}

std::string with_unit(double value, const QuantityKind& kind) {
  return fmt::format("{:g}{}{}", value, *kind.unit == 0 ? "" : " ", kind.unit);
}

}  // namespace

double parse_option(const QuantityKind& kind, const std::string& text) {
  double value = 0;
  try {
    value = *kind.unit == 0 ? parse_number(text) : parse_quantity(text, kind.unit);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("--{}: {}", kind.name, std::string(error.what()).substr(0, 200)));
  }
  if (value < kind.low || value > kind.high || (kind.positive && !(value > 0))) {
    throw InputError(fmt::format("--{}: {} is out of range; give {} {} to {}", kind.name, with_unit(value, kind),
                                 kind.positive && kind.low == 0 ? "more than" : "from", with_unit(kind.low, kind),
                                 with_unit(kind.high, kind)));
  }
  return value;
}

void Inputs::set(const std::string& name, double value, const std::string& origin) {
  (void)quantity_kind(name);
  known_[name] = {value, origin};
}

void Inputs::set_if_unknown(const std::string& name, double value, const std::string& origin) {
  if (!has(name) && std::isfinite(value)) set(name, value, origin);
}

void Inputs::take_over(const Inputs& other) {
  for (const auto& [name, known] : other.known_) known_[name] = known;
}

double Inputs::value(const std::string& name) const {
  const KnownValue* const known = find(name);
  return known ? known->value : std::numeric_limits<double>::quiet_NaN();
}

const KnownValue* Inputs::find(const std::string& name) const {
  const auto found = known_.find(name);
  return found == known_.end() ? nullptr : &found->second;
}

}  // namespace thalweg
