#include "common/signals.hpp"

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace thalweg {
namespace {

// A signal may come to any thread.
std::atomic<int> stop = 0;
std::atomic<bool> write_now = false;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void remember_stop(int signal) { stop = signal; }
extern "C" void remember_write(int) { write_now = true; }

void handle(int signal, void (*handler)(int)) {
  struct sigaction before {};
  sigaction(signal, nullptr, &before);
  if (signal == SIGHUP && before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) handle(signal, remember_stop);
  handle(SIGUSR1, remember_write);
}

int stop_signal() { return stop; }

const char* signal_name(int signal) {
  switch (signal) {
    case SIGINT:
      return "Ctrl-C";
    case SIGHUP:
      return "SIGHUP";
    case SIGXCPU:
      return "SIGXCPU";
    default:
      return "SIGTERM";
  }
}

bool take_write_request() { return write_now.exchange(false); }

}  // namespace thalweg
