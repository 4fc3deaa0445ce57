// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pyramid_normals.h"

#include <gtest/gtest.h>

TEST(Pyramid, Todo) {}
