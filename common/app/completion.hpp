#pragma once

#include <string>
#include <vector>

#include "common/app/verbs.hpp"

namespace thalweg {

/// Scripts that complete commands, options, words of options and keys of the case file (`keys`: "numerics.spacing" …). Each shell's
/// script holds all that it needs and starts no program.
std::string bash_completion(const std::vector<VerbDescription>& verbs, const std::vector<std::string>& keys);
std::string zsh_completion(const std::vector<VerbDescription>& verbs, const std::vector<std::string>& keys);
std::string fish_completion(const std::vector<VerbDescription>& verbs, const std::vector<std::string>& keys);

/// The page of the manual of `thalweg` (no verb named) or of one of its commands, in troff's man format.
std::string overview_manual(const std::vector<Verb>& verbs);
std::string verb_manual(const VerbDescription& verb);

}  // namespace thalweg
