#include "common/app/scour/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <map>

#include "case/reader/case_file.hpp"
#include "common/app/scour/scene.hpp"
#include "common/app/scour/table.hpp"
#include "common/command_line.hpp"
#include "common/error.hpp"

namespace thalweg {
namespace {

struct FormulaOptions {
  std::string case_path;
  std::vector<std::string> overrides;
  std::map<std::string, std::string> texts;  // of the quantities, by their names
  std::string nose;
  std::string csv;
  bool json = false;
};

const std::map<std::string, PierNose>& nose_words() {
  static const std::map<std::string, PierNose> words{{"circular", PierNose::circular},
                                                     {"round", PierNose::round},
                                                     {"square", PierNose::square},
                                                     {"sharp", PierNose::sharp}};
  return words;
}

Inputs given_inputs(const FormulaOptions& options) {
  Inputs given;
  for (const QuantityKind& kind : quantity_kinds()) {
    const auto text = options.texts.find(kind.name);
    if (text != options.texts.end() && !text->second.empty())
      given.set(kind.name, parse_option(kind, text->second), std::string("--") + kind.name);
  }
  return given;
}

/// A subject that options define: the quantity that says it is there, and its name in the table.
struct OptionSubject {
  const char* quantity;
  ScourKind kind;
  const char* title;
};
constexpr std::array option_subjects{
    OptionSubject{"pier-width", ScourKind::pier, "pier"},
    OptionSubject{"pipe-diameter", ScourKind::pipe, "pipe"},
    OptionSubject{"contracted-width", ScourKind::contraction, "contraction"},
    OptionSubject{"jet-opening", ScourKind::wall_jet, "wall jet"},
    OptionSubject{"drop", ScourKind::plunge_pool, "fall"},
};

/// An option defines one subject: the first of its kind that the case shows, with its other values, or a new one.
void add_given(const Inputs& given, std::vector<ScourSubject>& subjects) {
  for (const OptionSubject& option : option_subjects) {
    if (!given.has(option.quantity)) continue;
    const auto is_of_kind = [&](const ScourSubject& subject) { return subject.kind == option.kind; };
    const auto first = std::find_if(subjects.begin(), subjects.end(), is_of_kind);
    if (first != subjects.end()) {
      subjects.erase(std::remove_if(first + 1, subjects.end(), is_of_kind), subjects.end());
      continue;
    }
    subjects.push_back({.kind = option.kind, .title = option.title, .nose = {}, .inputs = {}});
  }
  const auto is_jet = [](const ScourSubject& subject) { return subject.kind == ScourKind::wall_jet; };
  if (given.has("turbulence") && std::none_of(subjects.begin(), subjects.end(), is_jet))
    subjects.push_back({.kind = ScourKind::bed_protection, .title = "bed protection", .nose = {}, .inputs = {}});
}

PierNose nose_of(const std::string& word) {
  const auto found = nose_words().find(word);
  if (found == nose_words().end())
    throw InputError(
        fmt::format("--pier-nose: \"{}\" is not known; write circular, round, square or sharp", word.substr(0, 60)));
  return found->second;
}

/// The notes that no option has cured.
std::vector<std::string> notes_of(const SceneReading& reading, const Inputs& given) {
  std::vector<std::string> notes;
  for (const SceneNote& note : reading.notes)
    if (note.option.empty() || !given.has(note.option)) notes.push_back(note.text);
  return notes;
}

std::string nothing_seen(const FormulaOptions& options, const std::vector<std::string>& notes) {
  const std::string who = options.case_path.empty() ? "thalweg formulas" : options.case_path.substr(0, 80);
  if (!notes.empty())
    return fmt::format("{}: nothing is seen that the formulas know; {}", who, notes.back().substr(0, 150));
  return fmt::format(
      "{}: no pier, pipe, contraction, wall jet or fall is seen; give one by --pier-width, --pipe-diameter, "
      "--contracted-width, --jet-opening, --drop, or --turbulence of a bed protection",
      who);
}

/// Leaves out what an option contradicts: the case's flow where the flow is given, a jet's discharge where the jet is.
void forget_contradicted(const Inputs& given, Inputs& of_case, std::vector<ScourSubject>& subjects) {
  const auto given_any = [&](const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return given.has(name); });
  };
  const std::vector<std::string> flow{"velocity", "discharge", "slope"};
  if (given_any(flow))
    for (const std::string& name : flow) of_case.forget(name);
  if (given_any({"jet-velocity", "jet-opening"}))
    for (ScourSubject& subject : subjects) subject.inputs.forget("discharge");
}

std::vector<FormulaRow> rows_of(const FormulaOptions& options, const Inputs& given, SceneReading& reading) {
  add_given(given, reading.subjects);
  forget_contradicted(given, reading.inputs, reading.subjects);
  for (ScourSubject& subject : reading.subjects) {
    if (!options.nose.empty() && subject.kind == ScourKind::pier) subject.nose = nose_of(options.nose);
  }
  return formula_rows_of(reading, given);
}

void describe_options(CLI::App& app, FormulaOptions& options) {
  app.add_option("CASE", options.case_path, "Folder with case.toml, or the file; without one, options tell all");
  app.add_option("--set", options.overrides, "Overrides a key: flow.slope=0.001")->allow_extra_args(false);
  for (const QuantityKind& kind : quantity_kinds()) {
    const std::string unit = *kind.unit == 0 ? "" : fmt::format(" [{}]", kind.unit);
    app.add_option(std::string("--") + kind.name, options.texts[kind.name], kind.meaning + unit);
  }
  app.add_option("--pier-nose", options.nose, "circular (default), round, square or sharp");
  app.add_option("--csv", options.csv, "Writes the table into this file too");
  app.add_flag("--json", options.json, "Prints the table as JSON");
}

}  // namespace

int formulas_command(int argc, char** argv) {
  CLI::App app(
      "Empirical scour formulas for piers, pipes, contractions, wall jets and falls: what each gives, from what, and "
      "whether the scene is within its range.",
      "thalweg formulas");
  FormulaOptions options;
  describe_options(app, options);
  if (const auto answered = parse_command_line(app, argc, argv)) return *answered;
  if (options.case_path.empty() && !options.overrides.empty())
    throw InputError("--set: there is no case whose key could be set; name the case, or give the value by its option");
  SceneReading reading;
  if (!options.case_path.empty()) reading = read_scene(read_case(options.case_path, options.overrides));
  const Inputs given = given_inputs(options);
  const std::vector<FormulaRow> rows = rows_of(options, given, reading);
  const std::vector<std::string> notes = notes_of(reading, given);
  if (rows.empty()) throw InputError(nothing_seen(options, notes));
  if (options.json) {
    print_rows_json(std::cout, rows, notes);
  } else {
    print_rows(std::cout, rows, notes);
  }
  if (!options.csv.empty()) write_rows_csv(options.csv, rows);
  return static_cast<int>(Exit::done);
}

}  // namespace thalweg
