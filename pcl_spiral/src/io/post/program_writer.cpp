// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/program_writer.h>

#include "io/setting_names.h"

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

std::vector<Setting>
settingTable(ProgramHeader& h)
{
  return {
      Setting("spindle", "ProgramHeader::spindle_speed", "spindle speed", "spindle speed", "12000", h.spindle_speed)
          .in("rev/min", NumberRange::from(0.0))
          .zeroFor("no spindle command"),
      Setting("spindle_direction", "ProgramHeader::spindle_direction", "turning direction", "turning direction of the spindle: M3 or M4",
              "ccw", h.spindle_direction),
      Setting("coolant", "ProgramHeader::coolant", "coolant", "coolant from start to end", "flood", h.coolant),
      Setting("feed_mode", "FeedMode", "feed mode",
              "F of blocks that turn rotary axes: time of the block, or mm/min of the tip (fanuc, fanuc-ijk, siemens)", "per-minute",
              h.feed_mode),
      Setting("line_numbers", "ProgramHeader::line_step", "step of line numbers", "numbers lines N10 N20 ...; Heidenhain always", "10",
              h.line_step)
          .in("", NumberRange::from(0.0).upTo(1000.0))
          .zeroFor("none"),
      Setting("tool", "ProgramHeader::tool", "tool number", "number of the tool to call", "3", h.tool)
          .in("", NumberRange::from(0.0))
          .zeroFor("none"),
      Setting("decimals", "ProgramHeader::decimals", "decimals", "decimals of mm and degrees in programs", "3", h.decimals)
          .in("", NumberRange::from(3.0).upTo(6.0)),
  };
}

void
writeProgram(const std::string& file, const MachineProgram& program, Dialect dialect, const ProgramHeader& header)
{
  entryOf(dialect).write(file, program, header);
}

} // namespace pcl_spiral
