// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "interruption.h"

#include <atomic>

namespace gestalt::app {

namespace {

std::atomic<int> signalled{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not lock");

}  // namespace

Interruption::Interruption() {
  signalled = 0;
  struct sigaction action {};
  action.sa_handler = [](int signal) { signalled = signal; };
  action.sa_flags = int(SA_RESETHAND | SA_RESTART);
  ::sigaction(SIGINT, &action, &interrupt_before_);
  ::sigaction(SIGTERM, &action, &terminate_before_);
}

Interruption::~Interruption() {
  ::sigaction(SIGINT, &interrupt_before_, nullptr);
  ::sigaction(SIGTERM, &terminate_before_, nullptr);
}

int Interruption::signal() const { return signalled; }

}  // namespace gestalt::app
