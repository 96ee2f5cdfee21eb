#include "postproc/figures/script_template.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

namespace thalweg {

std::string fill_template(std::string_view text, const TemplateValues& values) {
  std::string filled;
  std::set<std::string> used;
  while (true) {
    const std::size_t begin = text.find("{{");
    filled += text.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const std::size_t end = text.find("}}", begin);
    const std::string name(text.substr(begin + 2, end == std::string_view::npos ? end : end - begin - 2));
    const auto found = values.find(name);
    if (end == std::string_view::npos || found == values.end()) {
      throw std::logic_error("script template: no value for {{" + name + "}}");
    }
    filled += found->second;
    used.insert(name);
    text.remove_prefix(end + 2);
  }
  for (const auto& [name, value] : values) {
    if (!used.contains(name)) throw std::logic_error("script template: no placeholder {{" + name + "}}");
  }
  return filled;
}

std::string script_number(double value) { return fmt::format("{:.6g}", value); }

}  // namespace thalweg
