#include "common/app/scour/table.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/csv.hpp"

namespace thalweg {
namespace {

std::string shown(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

}  // namespace

std::string limit_text(const LimitLeft& left) {
  return fmt::format("{} {:.3g} {} {:.3g}", left.name, left.value, left.below ? "<" : ">", left.limit);
}

std::string value_text(const FormulaRow& row) {
  if (row.value) return shown(*row.value, row.unit);
  return row.missing.empty() ? "none" : "?";
}

namespace {

std::vector<std::string> limit_texts(const FormulaRow& row) {
  std::vector<std::string> texts;
  std::transform(row.outside.begin(), row.outside.end(), std::back_inserter(texts), limit_text);
  return texts;
}

std::vector<std::string> input_texts(const FormulaRow& row) {
  std::vector<std::string> texts;
  for (const TakenInput& in : row.inputs)
    texts.push_back(fmt::format("{} {} ({})", in.name, shown(in.value, in.unit), in.origin));
  return texts;
}

std::string cures(const FormulaRow& row) {
  std::vector<std::string> texts;
  for (const std::string& name : row.missing) texts.push_back("--" + name);
  return fmt::format("not known: {}; give {}", fmt::join(row.missing, ", "), fmt::join(texts, ", "));
}

/// Prints texts behind a word, a line as long as they fit.
void print_wrapped(std::ostream& to, const std::string& word, const std::vector<std::string>& texts) {
  constexpr std::size_t width = 112;
  std::string line = "      " + word;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string text = " " + texts[i] + (i + 1 < texts.size() ? "," : "");
    if (line.size() + text.size() > width && line.size() > 11) {
      fmt::print(to, "{}\n", line);
      line = std::string(6 + word.size(), ' ');
    }
    line += text;
  }
  if (!texts.empty()) fmt::print(to, "{}\n", line);
}

}  // namespace

void print_rows(std::ostream& to, const std::vector<FormulaRow>& rows, const std::vector<std::string>& notes) {
  std::string subject;
  for (const FormulaRow& row : rows) {
    if (row.subject != subject) {
      subject = row.subject;
      fmt::print(to, "{}\n", subject);
    }
    const std::string outside =
        row.outside.empty() ? "" : fmt::format("  outside its range: {}", fmt::join(limit_texts(row), ", "));
    fmt::print(to, "  {:<26}{:<19}{:>11}{}\n", row.formula, row.gives, value_text(row), outside);
    if (!row.missing.empty()) fmt::print(to, "      {}\n", cures(row));
    print_wrapped(to, "from", input_texts(row));
    fmt::print(to, "      source: {}\n", row.source);
  }
  for (const std::string& note : notes) fmt::print(to, "note: {}\n", note);
}

void write_rows_csv(const std::filesystem::path& file, const std::vector<FormulaRow>& rows) {
  CsvTable table({{"subject", ""},
                  {"formula", ""},
                  {"gives", ""},
                  {"value", ""},
                  {"unit", ""},
                  {"outside its range", ""},
                  {"not known", ""},
                  {"inputs", ""},
                  {"source", ""}});
  for (const FormulaRow& row : rows) {
    table.add_row({row.subject, row.formula, row.gives, row.value ? csv_number(*row.value) : "", row.unit,
                   fmt::format("{}", fmt::join(limit_texts(row), "; ")),
                   fmt::format("{}", fmt::join(row.missing, "; ")),
                   fmt::format("{}", fmt::join(input_texts(row), "; ")), row.source});
  }
  table.write(file);
}

void print_rows_json(std::ostream& to, const std::vector<FormulaRow>& rows, const std::vector<std::string>& notes) {
  nlohmann::ordered_json document{{"rows", nlohmann::ordered_json::array()}, {"notes", notes}};
  for (const FormulaRow& row : rows) {
    nlohmann::ordered_json entry{{"subject", row.subject}, {"formula", row.formula}, {"gives", row.gives}};
    entry["value"] = row.value ? nlohmann::ordered_json(*row.value) : nlohmann::ordered_json(nullptr);
    entry["unit"] = row.unit;
    entry["outside"] = nlohmann::ordered_json::array();
    for (const LimitLeft& left : row.outside) {
      entry["outside"].push_back(
          {{"quantity", left.name}, {"value", left.value}, {left.below ? "at least" : "at most", left.limit}});
    }
    entry["missing"] = row.missing;
    entry["inputs"] = nlohmann::ordered_json::array();
    for (const TakenInput& in : row.inputs)
      entry["inputs"].push_back({{"name", in.name}, {"value", in.value}, {"unit", in.unit}, {"origin", in.origin}});
    entry["source"] = row.source;
    document["rows"].push_back(std::move(entry));
  }
  to << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
}

}  // namespace thalweg
