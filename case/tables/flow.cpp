#include "case/tables/flow.hpp"

#include <algorithm>

#include "case/case.hpp"
#include "case/tables/common_checks.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

/// The key with the drive's number; "" without a drive.
std::string key_of(Drive drive) {
  switch (drive) {
    case Drive::off:
      return "";
    case Drive::slope:
    case Drive::discharge:
    case Drive::velocity:
      break;
  }
  return word_for(drive);
}

void check_start(const Flow& flow, const Case& whole, const CheckContext& at) {
  for (const std::string& name : flow.start_of) {
    const auto found =
        std::find_if(whole.shapes.begin(), whole.shapes.end(), [&](const Shape& shape) { return shape.name == name; });
    if (found != whole.shapes.end() && found->role == ShapeRole::water) continue;
    at.reject("flow.start_of", fmt::format("flow.start_of names \"{}\", which is no shape of water", name),
              "name a [[shape]] with role = \"water\"");
  }
}

void check_guide(const Flow& flow, const Case& whole, const CheckContext& at) {
  if (!(flow.guide_length > 0)) return;
  const int axis = flow.component();
  const double low = whole.domain.from[axis];
  const double high = whole.domain.to[axis];
  if (!at.given("guide_from")) {
    at.reject("flow.guide_length", "flow.guide_length is given and flow.guide_from is not",
              "say where the zone begins");
  }
  if (flow.guide_from < low || flow.guide_from >= high) {
    at.reject(
        "flow.guide_from", "flow.guide_from lies outside of the domain",
        fmt::format("let the zone begin between {} and {}", format_quantity(low, "m"), format_quantity(high, "m")));
  }
  if (flow.guide_length > 0.5 * (high - low)) {
    at.reject("flow.guide_length", "flow.guide_length is more than half of the period", "make the zone shorter");
  }
  const double least = 10 * whole.numerics.spacing;
  if (flow.guide_length < least * (1 - 1e-9)) {
    at.reject("flow.guide_length", "flow.guide_length is less than ten spacings, which guides little",
              fmt::format("write {} at least", format_quantity(least, "m")));
  }
}

}  // namespace

bool Flow::uses_key(std::string_view key, int) const {
  if (key == "drive" || key == "start") return true;
  if (key == "start_of") return start != FlowStart::rest;
  if (key == "guide_length") return drive != Drive::off;
  if (key == "guide_from") return drive != Drive::off && guide_length > 0;
  if (drive != Drive::off) return key == "along" || key == key_of(drive);
  if (start == FlowStart::rest || key == "slope") return false;
  // Without a drive the start's own: one of the two numbers.
  return key == "along" || (key == "discharge" ? discharge > 0 || velocity == 0 : velocity > 0);
}

void Flow::check(const Case& whole, const CheckContext& at) const {
  check_unused_keys(at, *this, [&](const std::string& key) {
    if (key == "guide_from" && drive != Drive::off) return std::string("without guide_length");
    const bool of_start = key == "start_of" || (drive == Drive::off && start == FlowStart::rest && key != "slope");
    return of_start ? "with start = \"rest\"" : fmt::format("with drive = \"{}\"", word_for(drive));
  });
  if (drive == Drive::off && start == FlowStart::rest) return;
  if (drive == Drive::off && !(discharge + velocity > 0)) {
    at.reject("flow.start", fmt::format("start = \"{}\" without a drive needs the current's number", word_for(start)),
              "give flow.discharge or flow.velocity");
  }
  const std::string number = drive == Drive::off ? (discharge > 0 ? "discharge" : "velocity") : key_of(drive);
  const double value = drive == Drive::slope ? slope : number == "discharge" ? discharge : velocity;
  if (!(value > 0)) {
    at.reject("flow.drive", fmt::format("drive = \"{}\" needs flow.{} above 0", number, number),
              fmt::format("give flow.{}", number));
  }
  if (along != "x" && !(along == "y" && at.uses(1))) {
    at.reject("flow.along", fmt::format("flow.along = \"{}\" is no direction of a flow", along),
              at.uses(1) ? "write \"x\" or \"y\"" : "write \"x\" with dimension = 2");
  }
  check_start(*this, whole, at);
  check_guide(*this, whole, at);
}

}  // namespace thalweg
