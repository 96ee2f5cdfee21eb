#include "foam_reference/field_file.hpp"

#include <fstream>
#include <string>

#include "common/error.hpp"

namespace thalweg::foam {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw RunError(file.string() + ": " + what + "; run ./Allclean && ./Allrun in the case's folder again");
}

}  // namespace

std::vector<double> read_scalar_field(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail(file, "this field has not been written");

  bool binary = false;
  std::string line;
  while (std::getline(stream, line) && !line.starts_with("internalField")) {
    if (line.find("format") != std::string::npos && line.find("binary") != std::string::npos) binary = true;
    if (line.find("arch") != std::string::npos && line.find("scalar=64") == std::string::npos) {
      fail(file, "numbers are not of double precision");
    }
  }
  if (!stream) fail(file, "no internalField");

  std::vector<double> values;
  if (const std::size_t at = line.find(" uniform "); at != std::string::npos) {
    values.push_back(std::stod(line.substr(at + 9)));
    return values;
  }
  std::size_t count = 0;
  char open = 0;
  if (!(stream >> count >> open) || open != '(') fail(file, "internalField is not a list of numbers");
  values.resize(count);
  if (binary) {
    stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(double)));
  } else {
    for (double& value : values) stream >> value;
  }
  if (!stream) fail(file, "internalField ends early");
  return values;
}

}  // namespace thalweg::foam
