// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "paint.h"
#include "random.h"

namespace gestalt::synthesis {

/// Gives each new thing its colours: now and then nearly those of the thing before.
class Brands {
 public:
  explicit Brands(Random& random) : random_(random), palette_(random_palette(random)) {}
  const Palette& next() {
    palette_ = random_.chance(0.2) ? similar_palette(palette_, random_) : random_palette(random_);
    return palette_;
  }

 private:
  Random& random_;
  Palette palette_;
};

}  // namespace gestalt::synthesis
