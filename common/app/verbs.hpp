#pragma once

#include <string>
#include <vector>

namespace thalweg {

/// A command of `thalweg`. What it does and its options are told by its program (--describe).
struct Verb {
  std::string name;
  std::string arguments;  // as the overview shows them
  std::string meaning;    // a line of the overview
};

/// The commands that are there, in the order in which a user needs them. A program thalweg-NAME beside this one that the list
/// does not know comes last.
std::vector<Verb> verbs();

/// The overview: `thalweg help`.
std::string overview();

/// An option or an argument of a command.
struct VerbOption {
  std::vector<std::string> names;  // "--set", "-o"; empty for an argument
  std::string place;               // the name of an argument: "CASE"
  std::string value;               // what it takes: "FILE", "auto|cuda|openmp"; empty for a flag
  std::string meaning;
};

struct VerbDescription {
  Verb verb;
  std::string meaning;  // a sentence or two
  std::vector<VerbOption> options;
};

/// The description that a command gives of itself. A program that does not answer --describe has no options here.
VerbDescription describe(const Verb& verb);
/// All commands, in the order of verbs().
std::vector<VerbDescription> describe_verbs();

}  // namespace thalweg
