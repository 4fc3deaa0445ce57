// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gestalt::app {

/// From here on, a signal that ends the process (a segmentation fault, an abort, ...) first says on stderr which
/// component was at work: code of others cannot be contained, but it can be named. Handlers that are there, such as a
/// sanitizer's, stay.
void report_crashes();

}  // namespace gestalt::app
