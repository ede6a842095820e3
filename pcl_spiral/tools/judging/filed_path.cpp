// SPDX-License-Identifier: BSD-3-Clause
#include "filed_path.h"

#include "judge_options.h"
#include "terminal/file_names.h"
#include "terminal/scan_places.h"
#include "terminal/vocabulary.h"

#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>

#include <algorithm>

using namespace pcl_spiral;

bool
isProgramFile(const std::string& file)
{
  const std::string extension = extensionOf(file);
  return isProgramExtension(extension) || extension == ".apt" || extension == ".cls";
}

Option
dialectOption(ProgramReading& reading)
{
  return {"dialect", choiceList<Dialect>(),
          "language of a .nc; default found from its words; a .ngc is for LinuxCNC, a .mpf for Siemens, a .h for Heidenhain: --dialect "
          "siemens",
          [&reading](const std::string& value) { reading.dialect = choiceValue<Dialect>("dialect", value); }};
}

void
checkProgramFiles(const std::vector<std::string>& paths, const ProgramReading& reading, bool mesh)
{
  const bool any = std::any_of(paths.begin(), paths.end(), isProgramFile);
  require(!any || !mesh, "programs are judged by a scan; leave --mesh out, so that the vertices of the mesh are the scan");
  for (const std::string& path : paths) {
    require(!reading.machine_file.empty() || !isProgramExtension(extensionOf(path)),
            Diagnostic(path, ": a program has the axes of a machine; give its machine file, such as --machine xyzac.yaml"));
    if (const std::optional<Dialect> own = dialectOfExtension(extensionOf(path)); own && reading.dialect)
      require(*own == *reading.dialect, Diagnostic(path, ": is always for ", std::string(entryOf(*own).word), "; leave --dialect out"));
  }
}

FiledPath
readFiledPath(const std::string& file, const ProgramReading& reading)
{
  FiledPath filed;
  if (isProgramFile(file)) {
    const std::optional<Machine> machine = reading.machine_file.empty() ? std::nullopt : std::optional(readMachine(reading.machine_file));
    filed.path.program = readProgram(file, machine, reading.dialect);
    return filed;
  }
  ToolpathFile read = readToolpath(file, scanShift());
  filed.path.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(read.path));
  filed.path.tips = std::move(read.tips);
  filed.path.has_contacts = read.has_contacts;
  filed.feed = std::move(read.feed);
  return filed;
}
