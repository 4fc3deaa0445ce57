// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Debian's libsvm.a can go into a shared library but for two things: it addresses stdout and stderr as if they were
// variables of its own. Here they are; the linker's --wrap leads libsvm to them.

#include <cstdio>

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): the linker's names
extern FILE* __real_stdout;
extern FILE* __real_stderr;
[[gnu::visibility("hidden")]] FILE* __wrap_stdout = __real_stdout;
[[gnu::visibility("hidden")]] FILE* __wrap_stderr = __real_stderr;
// NOLINTEND(bugprone-reserved-identifier)
}
