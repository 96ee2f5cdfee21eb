#include "common/signals.hpp"

#include <csignal>
#include <initializer_list>

namespace thalweg {
namespace {

volatile std::sig_atomic_t stop = 0;
volatile std::sig_atomic_t write_now = 0;

extern "C" void remember_stop(int signal) { stop = signal; }
extern "C" void remember_write(int) { write_now = 1; }

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

bool take_write_request() {
  if (write_now == 0) return false;
  write_now = 0;
  return true;
}

}  // namespace thalweg
