#pragma once

#include <string>
#include <string_view>

namespace thalweg {

/// Reads "2 mm", "1540 kg/m^3" or "38 deg" with UDUNITS and returns the value in `unit_in_si` ("m", "kg/m^3", "rad" …).
/// Throws std::invalid_argument "what is wrong; what to do" for a missing, unknown or incompatible unit, a value that
/// is not finite, or text after the unit. The caller adds file and line.
double parse_quantity(std::string_view text, std::string_view unit_in_si);

/// A short text with a unit of fitting size (mm, cm, ms …), for logs and reports: 0.005 and "m" give "5 mm".
std::string format_quantity(double value, std::string_view unit_in_si);

}  // namespace thalweg
