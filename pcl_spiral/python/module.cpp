// SPDX-License-Identifier: BSD-3-Clause
// The module behind the package pcl_spiral.
#include "path.h"
#include "running.h"

namespace pcl_spiral::python {

py::list
keywordsOf(const std::string& function)
{
  for (const auto& [name, table] :
       {std::pair("spiral", &spiralKeywords), std::pair("drive", &driveKeywords), std::pair("ridge", &ridgeKeywords),
        std::pair("program", &programKeywords), std::pair("verify", &verifyKeywords)})
    if (function == name)
      return table();
  raiseType(Diagnostic("there is no function ", function));
}

} // namespace pcl_spiral::python

PYBIND11_MODULE(_core, module)
{
  using namespace pcl_spiral::python;
  module.attr("__version__") = PCL_SPIRAL_VERSION;
  module.def("keywords", &keywordsOf);
  addPath(module);
  addPlanning(module);
  addVerification(module);
  py::module_::import("atexit").attr("register")(py::cpp_function(&finishRuns));
}
