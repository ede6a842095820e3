// SPDX-License-Identifier: BSD-3-Clause
#include "stock_option.h"

#include "terminal/file_names.h"
#include "terminal/terminal.h"

Option
stockOption(std::vector<std::string>& files)
{
  return {"stock", "FILE",
          "the surface after cutting: a mesh, .ply with the height left at each vertex as stock, mm, negative for a gouge, or .stl; may be "
          "given several times: --stock left.ply --stock left.stl",
          [&files](const std::string& value) { files.push_back(value); }, true};
}

void
checkStockFiles(const std::vector<std::string>& files)
{
  for (const std::string& file : files)
    if (const std::string extension = extensionOf(file); extension != ".ply" && extension != ".stl")
      throw UsageError(pcl_spiral::Diagnostic("--stock ", file,
                                              ": the surface after cutting is a .ply or .stl file; give one of these, such as left.ply"));
}
