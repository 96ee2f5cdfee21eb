#pragma once

#include <map>
#include <string>

#include "case/case.hpp"

namespace thalweg::foam {

/// A number in a dictionary, with 12 digits at most.
std::string number(double value);

/// "(1 0 -9.81)".
std::string vector(const Vec3& value);

/// The template with each %name% replaced by its value. fmt's {} does not serve, since dictionaries are full of braces.
/// Throws std::logic_error for a name without value.
std::string substitute(const std::string& text, const std::map<std::string, std::string>& values);

/// Comment block for the head of a file: its writer, its case and its purpose. Each line begins with `comment` ("//" or
/// "#").
std::string origin(const Case& scene, const std::string& comment, const std::string& purpose);

/// A whole OpenFOAM file: origin, FoamFile entry of the given class ("dictionary", "volScalarField" …), body.
std::string foam_file(const Case& scene, const std::string& foam_class, const std::string& object,
                      const std::string& purpose, const std::string& body);

}  // namespace thalweg::foam
