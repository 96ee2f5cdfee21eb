#pragma once

#include <map>
#include <string>
#include <string_view>

namespace thalweg {

/// Values of a template's placeholders, by their names.
using TemplateValues = std::map<std::string, std::string>;

/// A text with every {{name}} replaced by its value. The gnuplot scripts in figures/scripts are such texts, compiled
/// into the program. Throws std::logic_error for a placeholder without a value, or a value without a placeholder: then
/// program and template do not belong together.
std::string fill_template(std::string_view text, const TemplateValues& values);

/// A number as scripts take it, with six digits.
std::string script_number(double value);

}  // namespace thalweg
