// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks what a shared library shows; everything else is built with hidden visibility.
#define GESTALT_EXPORT __attribute__((visibility("default")))
