// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/string.h>

#include <slamicp/error.hpp>

#include "module.hpp"
#include "refusal.hpp"

namespace slamicp::python {
namespace {

namespace nb = nanobind;

void raise(nb::handle type, const char* words, const char* code) {
  const nb::object error = type(words);
  error.attr("code") = code;
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void bind_errors(nb::module_& m) {
  PyObject* const type = PyErr_NewExceptionWithDoc(
      "slamicp.Error",
      "Wrong use or a broken file. The message says what is wrong, where, and how to mend it.\n\n"
      "`code` is one of 'bad_points', 'bad_pose', 'bad_scan', 'bad_options', 'bad_state', or 'error' where a file is "
      "the "
      "matter.\nWhat may happen on a good day (no overlap, a featureless corridor) is never an Error: it is the\n"
      "result's `stop`.",
      PyExc_ValueError, nullptr);
  m.attr("Error") = nb::steal(type);
  nb::register_exception_translator(
      [](const std::exception_ptr& thrown, void* payload) {
        const nb::handle error(static_cast<PyObject*>(payload));
        try {
          std::rethrow_exception(thrown);
        } catch (const c::Refusal& refusal) {
          raise(error, refusal.what(), slamicp_status_name(refusal.status()));
        } catch (const Error& of_library) {
          raise(error, of_library.what(), "error");
        }
      },
      type);
}

}  // namespace slamicp::python
