#include "foam_reference/function_table.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "common/error.hpp"

namespace thalweg::foam {

std::vector<std::vector<double>> read_table(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw RunError(file.string() + ": this table has not been written; see the solver's log");
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("#")) continue;
    std::ranges::replace_if(
        line, [](char c) { return c == '(' || c == ')'; }, ' ');  // around a vector
    std::istringstream text(line);
    rows.emplace_back();
    for (double value = 0; text >> value;) rows.back().push_back(value);
  }
  return rows;
}

}  // namespace thalweg::foam
