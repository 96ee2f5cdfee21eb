#include "foam_reference/dictionary.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "common/version.hpp"

namespace thalweg::foam {

std::string number(double value) { return fmt::format("{:.12g}", value); }

std::string vector(const Vec3& value) {
  return fmt::format("({} {} {})", number(value.x()), number(value.y()), number(value.z()));
}

std::string substitute(const std::string& text, const std::map<std::string, std::string>& values) {
  std::string filled;
  std::size_t done = 0;
  for (std::size_t open = text.find('%'); open != std::string::npos; open = text.find('%', done)) {
    const std::size_t close = text.find('%', open + 1);
    if (close == std::string::npos) throw std::logic_error("a %name% is not closed in a dictionary's template");
    const auto value = values.find(text.substr(open + 1, close - open - 1));
    if (value == values.end()) throw std::logic_error("no value for " + text.substr(open, close - open + 1));
    filled += text.substr(done, open - done) + value->second;
    done = close + 1;
  }
  return filled + text.substr(done);
}

std::string origin(const Case& scene, const std::string& comment, const std::string& purpose) {
  std::string lines = comment + " Written by thalweg-foam " + release_of(version()) + " from " +
                      scene.file.filename().string() + " of the case \"" + scene.info.name + "\".\n" + comment +
                      " Changes made here are lost at the next run of thalweg-foam; ./Allrun keeps them.\n";
  std::istringstream stream(purpose);
  for (std::string line; std::getline(stream, line);) lines += comment + " " + line + "\n";
  return lines;
}

std::string foam_file(const Case& scene, const std::string& foam_class, const std::string& object,
                      const std::string& purpose, const std::string& body) {
  return origin(scene, "//", purpose) +
         substitute(R"(
FoamFile
{
    version     2.0;
    format      ascii;
    class       %class%;
    object      %object%;
}

)",
                    {{"class", foam_class}, {"object", object}}) +
         body;
}

}  // namespace thalweg::foam
