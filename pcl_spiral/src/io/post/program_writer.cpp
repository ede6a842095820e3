// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/program_writer.h>

#include <algorithm>

namespace pcl_spiral {

const DialectEntry&
entryOf(Dialect dialect)
{
  return *std::find_if(dialect_entries.begin(), dialect_entries.end(),
                       [dialect](const DialectEntry& entry) { return entry.dialect == dialect; });
}

std::optional<Dialect>
dialectOfExtension(const std::string& extension)
{
  const auto found = std::find_if(dialect_entries.begin(), dialect_entries.end(),
                                  [&extension](const DialectEntry& entry) { return !extension.empty() && entry.extension == extension; });
  return found == dialect_entries.end() ? std::nullopt : std::optional(found->dialect);
}

bool
isProgramExtension(const std::string& extension)
{
  return extension == ".nc" || dialectOfExtension(extension);
}

void
writeProgram(const std::string& file, const MachineProgram& program, Dialect dialect, const ProgramHeader& header)
{
  entryOf(dialect).write(file, program, header);
}

} // namespace pcl_spiral
