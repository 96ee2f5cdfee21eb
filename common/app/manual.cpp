#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/app/completion.hpp"
#include "common/version.hpp"

namespace thalweg {
namespace {

/// Text for troff: a backslash, and a dot or quote at the start of a line, mean something to it; hyphens of options stay hyphens.
std::string troff(const std::string& text) {
  std::string safe = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\') safe += "\\e";
    if (c == '-') safe += "\\-";
    if (c != '\\' && c != '-') safe += c;
  }
  return safe;
}

std::string heading(const std::string& page, const std::string& name, const std::string& meaning) {
  return fmt::format(".TH {} 1 \"\" \"Thalweg {}\" \"Thalweg\"\n.SH NAME\n{} \\- {}\n", page, version(), troff(name),
                     troff(meaning));
}

std::string see_also() {
  return ".SH EXIT STATUS\n0: done; 1: the run failed; 2: the input is wrong; 128 + n: ended by signal n. An error is "
         "one line on standard error with cause and cure.\n"
         ".SH SEE ALSO\n.BR thalweg (1);\nthe pages in the documentation folder of the installed tree, "
         "share/doc/thalweg.\n";
}

}  // namespace

std::string overview_manual(const std::vector<Verb>& verbs) {
  std::string text = heading("THALWEG", "thalweg", "scour of a sediment bed by water, from a case file to a report");
  text += ".SH SYNOPSIS\n.B thalweg\n.I COMMAND\n[arguments]\n.SH COMMANDS\n";
  for (const Verb& verb : verbs)
    text += fmt::format(".TP\n.B {}\n{}\n", troff(verb.name + " " + verb.arguments), troff(verb.meaning));
  return text +
         ".PP\n.B thalweg help\n.I COMMAND\nprints the options of a command, and so does the page "
         "thalweg\\-COMMAND(1).\n" +
         see_also();
}

std::string verb_manual(const VerbDescription& verb) {
  const std::string name = "thalweg-" + verb.verb.name;
  std::string text = heading(fmt::format("THALWEG\\-{}", troff(verb.verb.name)), name, verb.verb.meaning);
  text += fmt::format(".SH SYNOPSIS\n.B thalweg {}\n{} [options]\n.SH DESCRIPTION\n{}\n.SH OPTIONS\n", verb.verb.name,
                      troff(verb.verb.arguments), troff(verb.meaning));
  for (const VerbOption& option : verb.options) {
    const std::string names = option.names.empty() ? option.place : fmt::format("{}", fmt::join(option.names, ", "));
    const std::string value = option.names.empty() || option.value.empty() ? "" : " " + option.value;
    text += fmt::format(".TP\n.B {}{}\n{}\n", troff(names), troff(value), troff(option.meaning));
  }
  return text + see_also();
}

}  // namespace thalweg
