#include "gencase/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/units.hpp"

namespace thalweg::gencase {
namespace {

/// True if `digits` digits tell a length to a hundredth of the spacing.
bool suffices(double metres, double spacing, int digits) {
  if (metres == 0 || !std::isfinite(metres)) return true;
  const double rounding = 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(metres))) + 1 - digits);
  return rounding <= 0.01 * spacing;
}

std::string with_all_digits(double metres, double spacing) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(0.01 * spacing))), 0, 15);
  std::string text = fmt::format("{:.{}f}", metres, decimals);
  if (decimals == 0) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string placed_text(double metres, double spacing) {
  constexpr int digits = 4;  // of format_quantity
  return suffices(metres, spacing, digits) ? format_quantity(metres, "m") : with_all_digits(metres, spacing) + " m";
}

std::string placed_text(const Case& scene, const Vec3& place) {
  const auto text = [&](double metres) { return placed_text(metres, scene.numerics.spacing); };
  return scene.info.dimension == 2
             ? fmt::format("x = {}, z = {}", text(place.x()), text(place.z()))
             : fmt::format("x = {}, y = {}, z = {}", text(place.x()), text(place.y()), text(place.z()));
}

std::string placed_number(double metres, double spacing) {
  constexpr int digits = 6;
  return suffices(metres, spacing, digits) ? fmt::format("{:.6g}", metres) : with_all_digits(metres, spacing);
}

std::string length_text(double metres) { return format_quantity(metres, "m"); }

}  // namespace thalweg::gencase
