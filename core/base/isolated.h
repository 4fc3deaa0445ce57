// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tbb/task_group.h>

namespace gestalt {

/// Does work whose parallel loops a caller's TBB group cannot cancel: a loop that is cancelled ends early without a
/// sign, and what follows would take its result for complete. Throws what work throws.
template <class Work>
void isolated(const Work& work) {
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::task_group group(context);
  group.run_and_wait(work);
}

}  // namespace gestalt
