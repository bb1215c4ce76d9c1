#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "core/version.h"
#include "python/native/bindings.h"
#include "python/native/failure.h"
#include "python/native/math_binding.h"

namespace nb = nanobind;

NB_MODULE(_native, module) {
  using namespace unietp;
  python::bind_math_functions();
  module.doc() = "The compiled part of unietp. Use the package's own functions and classes.";
  nb::exception<python::PythonError>(module, "Error", PyExc_ValueError);
  module.def(
      "version", [] { return std::string(program_version()); }, "\"0.1.0\"");
  module.def(
      "build", [] { return std::string(program_build()); }, "Compiler, build type and commit.");
  module.def(
      "math_bindings",
      [] {
        std::vector<std::tuple<std::string, std::string, bool>> rows;
        for (const auto& row : python::math_bindings()) rows.emplace_back(row.library, row.function, row.own);
        return rows;
      },
      "Library, function, and whether its calls go to core/math_functions.cpp, for all libraries that this needs.");
  python::define_catalog(module);
  python::define_data_files(module);
  python::define_settings(module);
  python::define_environment(module);
  python::define_batch(module);
}
