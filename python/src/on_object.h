// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <utility>

namespace gestalt::python {

/// The object of a method. One that was never initialised, from `cls.__new__(cls)`, is a TypeError; pybind11 itself
/// would give a method memory without content.
template <class Class>
struct Self {
  Class& object;
};

/// A const or other member function, or a data member to read, as what pybind11 binds.
template <class Class, class Returned, class... Arguments>
auto on_object(Returned (Class::*member)(Arguments...) const) {
  return [member](Self<Class> self, Arguments... arguments) -> Returned {
    return (self.object.*member)(std::forward<Arguments>(arguments)...);
  };
}

template <class Class, class Returned, class... Arguments>
auto on_object(Returned (Class::*member)(Arguments...)) {
  return [member](Self<Class> self, Arguments... arguments) -> Returned {
    return (self.object.*member)(std::forward<Arguments>(arguments)...);
  };
}

template <class Class, class Value>
auto on_object(Value Class::*member) {
  return [member](Self<Class> self) -> Value { return self.object.*member; };
}

}  // namespace gestalt::python

namespace pybind11::detail {

template <class Class>
struct type_caster<gestalt::python::Self<Class>> {
  static constexpr auto name = make_caster<Class>::name;

  template <class>
  using cast_op_type = gestalt::python::Self<Class>;

  bool load(handle source, bool) {
    if (!isinstance<Class>(source)) return false;
    auto* const self = reinterpret_cast<instance*>(source.ptr());
    if (!self->get_value_and_holder(get_type_info(typeid(Class))).holder_constructed()) return false;
    object_ = source.cast<Class*>();
    return true;
  }

  operator gestalt::python::Self<Class>() { return {*object_}; }

 private:
  Class* object_ = nullptr;
};

}  // namespace pybind11::detail
