#include "common/app/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace thalweg {
namespace {

using Words = std::vector<std::string>;

/// The words that an option takes: "auto|cuda|openmp", or "TEXT:{paper}" as CLI11 shows it.
Words words_of(const std::string& value) {
  const auto open = value.find('{');
  std::string list = open == std::string::npos ? value : value.substr(open + 1, value.find('}') - open - 1);
  if (open == std::string::npos && list.find('|') == std::string::npos) return {};
  std::replace(list.begin(), list.end(), ',', '|');
  Words words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, '|');) words.push_back(word);
  return words;
}

bool takes_keys(const VerbOption& option) {
  return std::find(option.names.begin(), option.names.end(), "--set") != option.names.end();
}

bool explains_keys(const VerbOption& option) { return option.names.empty() && option.place == "KEY"; }

std::string quoted(std::string text) {
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + 4))
    text.replace(at, 1, "'\\''");
  return "'" + text + "'";
}

Words names_of(const std::vector<VerbDescription>& verbs) {
  Words names;
  for (const VerbDescription& each : verbs) names.push_back(each.verb.name);
  return names;
}

/// The words that the arguments of a command are taken from; empty where they are files.
Words argument_words(const VerbDescription& verb, const Words& keys, const Words& commands) {
  for (const VerbOption& option : verb.options) {
    if (!option.names.empty()) continue;
    if (explains_keys(option)) return keys;
    if (option.place == "COMMAND") return commands;
    if (const Words words = words_of(option.value); !words.empty()) return words;
  }
  return {};
}

Words assignments(const Words& keys) {
  Words words;
  for (const std::string& key : keys) words.push_back(key + "=");
  return words;
}

}  // namespace

std::string bash_completion(const std::vector<VerbDescription>& verbs, const Words& keys) {
  const Words commands = names_of(verbs);
  std::string text =
      "# Completion of thalweg for bash; made by `thalweg completion bash`.\n"
      "_thalweg() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
      "  local command=${COMP_WORDS[1]} words=''\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n";
  text += fmt::format("    mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$word\")\n    return\n  fi\n",
                      fmt::join(commands, " "));
  text += "  case $command:$before in\n";
  for (const VerbDescription& each : verbs) {
    for (const VerbOption& option : each.options) {
      if (option.names.empty() || option.value.empty()) continue;
      const Words words = takes_keys(option) ? assignments(keys) : words_of(option.value);
      for (const std::string& name : option.names) {
        if (!words.empty()) {
          text += fmt::format("    {}:{}) words='{}' ;;\n", each.verb.name, name, fmt::join(words, " "));
        }
      }
    }
  }
  text +=
      "  esac\n"
      "  if [[ -n $words ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
      "    [[ ${COMPREPLY[0]:-} != *= ]] || compopt -o nospace\n"
      "    return\n"
      "  fi\n"
      "  case $command in\n";
  for (const VerbDescription& each : verbs) {
    Words options;
    for (const VerbOption& option : each.options)
      options.insert(options.end(), option.names.begin(), option.names.end());
    const Words arguments = argument_words(each, keys, commands);
    text += fmt::format("    {}) words='{}'", each.verb.name, fmt::join(options, " "));
    if (!arguments.empty()) text += fmt::format("; [[ $word == -* ]] || words='{}'", fmt::join(arguments, " "));
    text += " ;;\n";
  }
  text +=
      "  esac\n"
      "  if [[ $word == -* || $command == explain || $command == help || $command == completion ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
      "  else\n"
      "    compopt -o default 2>/dev/null\n"
      "  fi\n"
      "}\n"
      "complete -F _thalweg thalweg\n";
  return text;
}

std::string zsh_completion(const std::vector<VerbDescription>& verbs, const Words& keys) {
  const auto plain = [](std::string text) {  // of what _arguments and _describe take for their own marks
    std::replace(text.begin(), text.end(), '[', '(');
    std::replace(text.begin(), text.end(), ']', ')');
    std::replace(text.begin(), text.end(), ':', ',');
    return text;
  };
  const Words commands = names_of(verbs);
  std::string text =
      "#compdef thalweg\n# Completion of thalweg for zsh; made by `thalweg completion zsh`.\n_thalweg() {\n";
  text += fmt::format("  local -a keys=({})\n", fmt::join(keys, " "));
  text += "  if ((CURRENT == 2)); then\n    local -a commands=(\n";
  for (const VerbDescription& each : verbs)
    text += fmt::format("      {}\n", quoted(each.verb.name + ":" + plain(each.verb.meaning)));
  text +=
      "    )\n    _describe command commands\n    return\n  fi\n  local command=$words[2]\n  shift words\n  "
      "((CURRENT--))\n";
  text += "  case $command in\n";
  for (const VerbDescription& each : verbs) {
    text += fmt::format("    {}) _arguments", each.verb.name);
    for (const VerbOption& option : each.options) {
      const Words choice = words_of(option.value);
      const std::string from = takes_keys(option) || explains_keys(option) ? "compadd -S '' -a keys"
                               : !choice.empty()                           ? fmt::format("({})", fmt::join(choice, " "))
                               : option.place == "COMMAND" ? fmt::format("({})", fmt::join(commands, " "))
                                                           : "_files";
      const std::string action = from.starts_with("compadd") ? "{" + from + "}" : from;
      if (option.names.empty()) {
        text += fmt::format(" \\\n      {}", quoted("*:" + plain(option.place) + ":" + action));
        continue;
      }
      for (const std::string& name : option.names) {
        const std::string value = option.value.empty() ? "" : ":value:" + action;
        text += fmt::format(" \\\n      {}", quoted("*" + name + "[" + plain(option.meaning) + "]" + value));
      }
    }
    text += " ;;\n";
  }
  return text + "  esac\n}\n_thalweg \"$@\"\n";
}

std::string fish_completion(const std::vector<VerbDescription>& verbs, const Words& keys) {
  std::string text = "# Completion of thalweg for fish; made by `thalweg completion fish`.\n";
  const Words commands = names_of(verbs);
  for (const VerbDescription& each : verbs) {
    text += fmt::format("complete -c thalweg -n __fish_use_subcommand -f -a {} -d {}\n", each.verb.name,
                        quoted(each.verb.meaning));
  }
  for (const VerbDescription& each : verbs) {
    const std::string when = fmt::format("complete -c thalweg -n '__fish_seen_subcommand_from {}'", each.verb.name);
    const Words arguments = argument_words(each, keys, commands);
    if (!arguments.empty()) text += fmt::format("{} -f -a '{}'\n", when, fmt::join(arguments, " "));
    for (const VerbOption& option : each.options) {
      if (option.names.empty()) continue;
      text += when;
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.value.empty()) text += " -r";
      const Words words = takes_keys(option) ? assignments(keys) : words_of(option.value);
      if (!words.empty()) text += fmt::format(" -f -a '{}'", fmt::join(words, " "));
      text += fmt::format(" -d {}\n", quoted(option.meaning));
    }
  }
  return text;
}

}  // namespace thalweg
