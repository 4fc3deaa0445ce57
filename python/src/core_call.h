// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cxxabi.h>
#include <pybind11/pybind11.h>
#include <tbb/task_arena.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace gestalt::python {

namespace py = pybind11;

/// A call of Python's into the core while it lives, made and destroyed with the interpreter held: guard of each
/// function that computes (Computing). Where the interpreter ends meanwhile, it waits for the calls of other threads,
/// which then do not return to it: Python ends such threads in a way that C++ does not survive.
class CoreCall {
 public:
  /// Throws Error where the interpreter is ending, and in a process that was forked from one whose threads are missed.
  CoreCall();
  ~CoreCall();
  CoreCall(const CoreCall&) = delete;
  CoreCall& operator=(const CoreCall&) = delete;
};

using Computing = py::call_guard<CoreCall>;

/// Has the interpreter wait for calls before it ends, and notes forks. Once, when the module is loaded.
void watch_process();

/// Whether the interpreter begins no more work.
bool interpreter_is_ending() noexcept;

/// Throws Error where it is so: for loops over scenes, and before Python is called back.
void require_interpreter();

/// Forks so far, counted in the children.
int forks() noexcept;

/// Ends a child that was forked inside a component and came back out of it: the frame's other threads are not there.
[[noreturn]] void end_forked_frame() noexcept;

/// Keeps what a component raised to stop this thread's call, which the core knows as another error or, where the frame
/// was another thread's, not at all.
void note_interruption(const py::error_already_set& raised);

/// Whether there is one: it is raised then, and forgotten.
bool raise_interruption();

/// Never returns. For a thread that Python is about to end, by an unwinding that no C++ function may stop.
[[noreturn]] void stay() noexcept;

/// f() with the interpreter held, on whatever thread.
template <class F>
auto hold_interpreter(F f) {
  require_interpreter();
  struct SameProcess {
    ~SameProcess() {
      if (forks() != before) end_forked_frame();
    }
    int before = forks();
  };
  try {
    const py::gil_scoped_acquire gil;
    const SameProcess same;
    return f();
  } catch (const abi::__forced_unwind&) {
    stay();
  }
}

/// function(arguments...) of Python, with the interpreter held. Throws what it raises.
template <class... Arguments>
py::object call_python(const py::handle& function, Arguments&&... arguments) {
  const py::tuple given = py::make_tuple(std::forward<Arguments>(arguments)...);
  PyObject* answer = nullptr;
  try {
    answer = PyObject_CallObject(function.ptr(), given.ptr());
  } catch (const abi::__forced_unwind&) {
    stay();  // here, as destructors further up would touch objects of an interpreter that is no longer held
  }
  if (!answer) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(answer);
}

/// While it lives, the interpreter is released.
class Released {
 public:
  Released() : state_(PyEval_SaveThread()) {}
  ~Released();
  Released(const Released&) = delete;
  Released& operator=(const Released&) = delete;

 private:
  PyThreadState* state_;
};

/// The threads of a segmenter, or of one call.
class Arena {
 public:
  /// 0: all.
  explicit Arena(int threads);

  /// f() in these threads, with the interpreter released. Within a CoreCall.
  template <class F>
  auto run(F f) const {
    note_threads();
    if constexpr (std::is_void_v<decltype(f())>) {
      released(f);
    } else {
      auto answer = released(f);
      if (raise_interruption()) throw py::error_already_set();
      return answer;
    }
  }

 private:
  template <class F>
  auto released(F f) const {
    const Released released;
    return arena_->execute(f);
  }

  void note_threads() const;

  std::shared_ptr<tbb::task_arena> arena_;
};

}  // namespace gestalt::python
