#include "case/tables/flow.hpp"

#include <algorithm>

#include "case/case.hpp"
#include "case/tables/common_checks.hpp"

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

}  // namespace

bool Flow::uses_key(std::string_view key, int) const {
  if (key == "drive" || key == "start") return true;
  if (key == "start_of") return start != FlowStart::rest;
  if (drive != Drive::off) return key == "along" || key == key_of(drive);
  if (start == FlowStart::rest || key == "slope") return false;
  // Without a drive the start's own: one of the two numbers.
  return key == "along" || (key == "discharge" ? discharge > 0 || velocity == 0 : velocity > 0);
}

void Flow::check(const Case& whole, const CheckContext& at) const {
  check_unused_keys(at, *this, [&](const std::string& key) {
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
}

}  // namespace thalweg
