#include "cli/signals.hpp"

#include <csignal>

#include "io/output_file.hpp"

namespace delone::cli {
namespace {

extern "C" void clean_up_and_die(int signal_number) {
  io::remove_temporary_files();
  // SA_RESETHAND has put the default action back, so this second delivery kills the
  // process and the parent sees a death by signal (a shell shows 130 for Ctrl-C).
  raise(signal_number);
}

void handle(int signal_number) {
  struct sigaction current {};
  sigaction(signal_number, nullptr, &current);
  if (current.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = clean_up_and_die;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(signal_number, &action, nullptr);
}

}  // namespace

void install_signal_handlers() {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
    handle(signal_number);
}

}  // namespace delone::cli
