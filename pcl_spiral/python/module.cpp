// SPDX-License-Identifier: BSD-3-Clause
// The module behind the package pcl_spiral.
#include "path.h"
#include "running.h"

#include <pybind11/stl.h>

PYBIND11_MODULE(_core, module)
{
  using namespace pcl_spiral::python;
  py::dict tables;
  addPath(module);
  addPlanning(module, tables);
  addPrograms(tables);
  addVerification(module, tables);
  addSurfaceStages(module, tables);
  addSpiralStages(module, tables);
  module.def("_say", [](const std::map<std::string, std::string>& words, const std::string& sentence) {
    raise("failed", pcl_spiral::Diagnostic(sentence.c_str()),
          Words({words, false, nullptr, nullptr})); // as a call with these keywords says it: for tests
  });
  module.attr("__version__") = PCL_SPIRAL_VERSION;
  module.attr("tables") = tables;
  py::module_::import("atexit").attr("register")(py::cpp_function(&finishRuns));
  py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") = py::cpp_function(&forgetRuns));
}
