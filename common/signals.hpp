#pragma once

// Signals that ask a run to end in its own way, or to write now.
namespace thalweg {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGXCPU are remembered instead of ending the program, and so is SIGUSR1. A
/// SIGHUP that was ignored (nohup) stays ignored. Called first thing in main, so that no moment of a run is without it.
void catch_signals();

/// The signal that asks to end; 0: none has come.
int stop_signal();

/// "Ctrl-C", "SIGTERM", …
const char* signal_name(int signal);

/// True once after each SIGUSR1.
bool take_write_request();

}  // namespace thalweg
