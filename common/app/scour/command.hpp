#pragma once

namespace thalweg {

/// `thalweg formulas [CASE] [options]`: empirical scour formulas for what a case shows, or for what options give.
/// argv[0] is the command's name. Returns the exit status; throws InputError.
int formulas_command(int argc, char** argv);

}  // namespace thalweg
