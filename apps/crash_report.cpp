// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "crash_report.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "gestalt/apps/commands/command.h"
#include "gestalt/core/plugin/running_component.h"

namespace gestalt::app {

namespace {

void say(const char* text) {
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;  // nobody listens
}

const char* name_of(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "segmentation fault";
    case SIGBUS:
      return "bus error";
    case SIGFPE:
      return "arithmetic fault";
    case SIGILL:
      return "illegal instruction";
    default:
      return "abort";
  }
}

std::terminate_handler otherwise = nullptr;

/// Only what a signal handler may call.
void report_end(const char* how) {
  say("gestalt: error: ");
  say(how);
  if (const char* component = running_component()) {
    say(" while ");
    say(component);
    say(" was running; report this to its author, or remove it from the config");
  }
  say("\n");
}

void report(int signal) {
  report_end(name_of(signal));
  raise(signal);  // the handler is taken back when it is called, so that this ends the process as the fault would
}

std::atomic<bool> is_unfinished = false;

void refuse_exit() {
  if (!is_unfinished) return;
  report_end("exit() was called");
  _exit(run_failed);
}

/// Memory may end where no exception may leave, as in a destructor of a library.
[[noreturn]] void report_lack_of_memory() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    say("gestalt: error: out of memory; raise the memory limit of this process\n");
    _exit(run_failed);
  } catch (...) {
  }
  otherwise();
  std::abort();
}

}  // namespace

void report_crashes() {
  otherwise = std::set_terminate(report_lack_of_memory);
  static std::array<char, 65536> stack;  // for the fault of a stack that is full
  const stack_t other{stack.data(), 0, stack.size()};
  sigaltstack(&other, nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    struct sigaction known {};
    if (sigaction(signal, nullptr, &known) != 0 || known.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = report;
    action.sa_flags = int(SA_RESETHAND) | SA_NODEFER | SA_ONSTACK;
    sigaction(signal, &action, nullptr);
  }
}

Unfinished::Unfinished() {
  static const bool registered = std::atexit(refuse_exit) == 0 && std::at_quick_exit(refuse_exit) == 0;
  is_unfinished = registered;
}

Unfinished::~Unfinished() { is_unfinished = false; }

}  // namespace gestalt::app
