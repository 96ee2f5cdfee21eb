#include "postproc/html.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <utility>

namespace thalweg::html {
namespace {

std::string contents_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned triple = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      triple = triple << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : digits[triple >> (18 - 6 * k) & 63U];
    }
  }
  return text;
}

std::string escape(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string typeset(std::string_view value) {
  const std::pair<const char*, const char*> rules[] = {
      {R"((^|[ (+])-(?=[0-9.]))", "$1\u2212"},
      {R"((\d)e\+?0*(\d+)\b)", "$1\u202f×\u202f10<sup>$2</sup>"},
      {R"((\d)e-0*(\d+)\b)", "$1\u202f×\u202f10<sup>\u2212$2</sup>"},
      {R"(\^(-?[0-9.]+|[a-z]))", "<sup>$1</sup>"},
      {R"((\d )us\b)", "$1µs"},
      {R"((\d )um\b)", "$1µm"},
  };
  std::string text = escape(value);
  for (const auto& [pattern, replacement] : rules) text = std::regex_replace(text, std::regex(pattern), replacement);
  return text;
}

std::string table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows,
                  const std::string& alignment, const std::string& css_class) {
  const auto cell = [&](const char* tag, std::size_t column, const std::string& content) {
    const bool number = column < alignment.size() && alignment[column] == 'r';
    return fmt::format("<{0}{1}>{2}</{0}>", tag, number ? " class=\"n\"" : "", content);
  };
  std::string text = css_class.empty() ? "<table>" : fmt::format("<table class=\"{}\">", css_class);
  if (!heads.empty()) {
    text += "\n<thead><tr>";
    for (std::size_t c = 0; c < heads.size(); ++c) text += cell("th", c, heads[c]);
    text += "</tr></thead>";
  }
  text += "\n<tbody>\n";
  const std::size_t columns = alignment.size();
  for (const std::vector<std::string>& row : rows) {
    if (row.size() == 1 && columns > 1) {
      text += fmt::format("<tr><td class=\"group\" colspan=\"{}\">{}</td></tr>\n", columns, row.front());
      continue;
    }
    text += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) text += cell("td", c, row[c]);
    text += "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

std::string inline_svg(const std::filesystem::path& file, const std::string& prefix, const std::string& title) {
  std::string svg = contents_of(file);
  const std::size_t start = svg.find("<svg");
  if (start == std::string::npos) return "";
  svg.erase(0, start);
  svg = std::regex_replace(svg, std::regex(R"(\bid=(['"]))"), "id=$1" + prefix + "_");
  svg = std::regex_replace(svg, std::regex(R"(href=(['"])#)"), "href=$1#" + prefix + "_");
  svg = std::regex_replace(svg, std::regex(R"(url\(#)"), "url(#" + prefix + "_");
  // gnuplot names its own curves in <title> elements, which browsers would show as tool tips.
  svg = std::regex_replace(svg, std::regex("<(title|desc)>[^<]*</(title|desc)>\\s*"), "");
  return svg.insert(4, fmt::format(" role=\"img\" aria-label=\"{}\"", escape(title)));
}

std::string inline_png(const std::filesystem::path& file, const std::string& title) {
  const std::string bytes = contents_of(file);
  if (bytes.empty()) return "";
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escape(title), base64(bytes));
}

std::string grouped(double number) {
  std::string digits = fmt::format("{:.0f}", number);
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  for (std::size_t at = digits.size(); at > first + 3;) {
    at -= 3;
    digits.insert(at, "\u202f");
  }
  return digits;
}

}  // namespace thalweg::html
