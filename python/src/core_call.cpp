// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core_call.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "gestalt/core/base/error.h"

namespace gestalt::python {

namespace {

std::atomic<int> calls = 0;
std::atomic<int> forked = 0;
std::atomic<bool> ending = false;
std::thread::id ending_thread;            ///< that of Python's main program, set before ending
std::atomic<bool> workers_begun = false;  ///< TBB may have threads of its own
std::atomic<bool> threads_lost = false;   ///< this process is a copy without the threads that were running

/// What stopped a call of this thread; touched with the interpreter held.
thread_local PyObject* interruption = nullptr;

/// A child has the thread that forked alone; what the others held stays locked, and what they computed is not finished.
void note_fork() {
  ++forked;
  if (calls > 0 || workers_begun) threads_lost = true;
  calls = 0;
}

/// Destructors of static objects, while threads still use these, end in a crash.
void leave_at_once(int status, void*) {
  if (calls == 0) return;
  std::fflush(nullptr);
  ::_exit(status);
}

/// Waits for the calls of other threads; one that takes longer is left where it is, and the process ends without it.
void end_calls() {
  constexpr std::chrono::seconds longest{5};
  ending_thread = std::this_thread::get_id();
  ending = true;
  const py::gil_scoped_release released;
  const auto begin = std::chrono::steady_clock::now();
  while (calls > 0 && std::chrono::steady_clock::now() - begin < longest)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (calls > 0) ::on_exit(leave_at_once, nullptr);
}

}  // namespace

CoreCall::CoreCall() {
  if (threads_lost)
    throw Error(
        "this process was forked while gestalt was using several threads, which fork() does not copy; use "
        "multiprocessing.get_context(\"spawn\"), or \"forkserver\", or fork before the first frame is computed");
  if (ending && std::this_thread::get_id() != ending_thread) {  // an exception would be printed as of a fault
    PyEval_SaveThread();
    stay();
  }
  require_interpreter();
  Py_CLEAR(interruption);
  ++calls;
}

CoreCall::~CoreCall() {
  if (!threads_lost) --calls;
  if (!ending) return;
  PyEval_SaveThread();
  stay();
}

void watch_process() {
  ::pthread_atfork(nullptr, nullptr, note_fork);
  py::module_::import("atexit").attr("register")(py::cpp_function(end_calls));
}

Released::~Released() {
  try {
    PyEval_RestoreThread(state_);
  } catch (const abi::__forced_unwind&) {
    stay();
  }
}

bool interpreter_is_ending() noexcept { return ending; }

void require_interpreter() {
  if (ending) throw Error("the interpreter is shutting down and starts no new work");
}

void note_interruption(const py::error_already_set& raised) {
  PyException_SetTraceback(raised.value().ptr(), raised.trace() ? raised.trace().ptr() : Py_None);
  Py_XDECREF(interruption);
  interruption = py::object(raised.value()).release().ptr();
}

bool raise_interruption() {
  if (!interruption) return false;
  PyErr_SetObject(PyExceptionInstance_Class(interruption), interruption);
  Py_CLEAR(interruption);
  return true;
}

int forks() noexcept { return forked; }

void end_forked_frame() noexcept {
  constexpr std::string_view message =
      "gestalt: error: a component in Python forked the process, and the copy came back to the frame, whose other "
      "threads "
      "it does not have; end such a process inside the component by os._exit()\n";
  (void)!::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(1);
}

void stay() noexcept {
  for (;;) ::pause();
}

Arena::Arena(int threads)
    : arena_(new tbb::task_arena(threads > 0 ? threads : int(tbb::task_arena::automatic)), [](tbb::task_arena* arena) {
        if (!threads_lost) delete arena;  // would wait for what lost threads hold
      }) {}

void Arena::note_threads() const {
  if (arena_->max_concurrency() > 1) workers_begun = true;
}

}  // namespace gestalt::python
