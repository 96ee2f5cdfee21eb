#include "foam_reference/field_file.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include "common/error.hpp"

namespace thalweg::foam {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw RunError(file.string() + ": " + what + "; run ./Allclean && ./Allrun in the case's folder again");
}

// The numbers of a field with `parts` numbers in each cell.
std::vector<double> read_field(const std::filesystem::path& file, std::size_t parts) {
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

  // Brackets stand around the numbers of a cell, in ascii.
  const auto read_numbers = [&](std::istream& from, std::vector<double>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      char bracket = 0;
      if (parts > 1 && i % parts == 0) from >> bracket;
      from >> numbers[i];
      if (parts > 1 && i % parts == parts - 1) from >> bracket;
    }
  };
  std::vector<double> numbers;
  if (const std::size_t at = line.find(" uniform "); at != std::string::npos) {
    std::istringstream text(line.substr(at + 9));
    numbers.resize(parts);
    read_numbers(text, numbers);
    if (!text) fail(file, "internalField is not a number");
    return numbers;
  }
  std::size_t count = 0;
  char open = 0;
  if (!(stream >> count >> open) || open != '(') fail(file, "internalField is not a list of numbers");
  numbers.resize(count * parts);
  if (binary) {
    stream.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  } else {
    read_numbers(stream, numbers);
  }
  if (!stream) fail(file, "internalField ends early");
  return numbers;
}

}  // namespace

std::vector<double> read_scalar_field(const std::filesystem::path& file) { return read_field(file, 1); }

std::vector<Vec3> read_vector_field(const std::filesystem::path& file) {
  const std::vector<double> numbers = read_field(file, 3);
  std::vector<Vec3> values(numbers.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = Vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
  return values;
}

}  // namespace thalweg::foam
