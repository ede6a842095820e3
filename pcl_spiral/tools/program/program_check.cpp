// SPDX-License-Identifier: BSD-3-Clause
#include "program_check.h"
#include "terminal/file_names.h"
#include "terminal/idle_options.h"
#include "terminal/option_values.h"

#include "common/readable_text.h"
#include "io/post/plan_program.h"
#include "io/setting_names.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <utility>

using namespace pcl_spiral;

namespace {

/** Checks the codes of a pass: lines of a program, both or none. */
void
checkCodes(const ProgramHeader& header, bool any_program, const std::set<std::string>& given)
{
  for (const auto& [name, code] : {std::pair("pass-begin", header.pass_begin), std::pair("pass-end", header.pass_end)}) {
    if (given.count(name) == 0)
      continue;
    const std::string option = std::string("--") + name + " " + readableText(code) + ": ";
    if (const Diagnostic fault = faultOfCode(code); !fault.empty())
      throw UsageError(Diagnostic(option, "the code ", fault));
    if (!any_program)
      throw UsageError(Diagnostic(option, "no output is a program; add an output .ngc, .nc, .mpf or .h, or leave it out"));
    if (given.count("pass-begin") != given.count("pass-end"))
      throw UsageError(Diagnostic(option,
                                  "is given without the other, and a beam that is never switched off burns the part; give both, such as "
                                  "--pass-begin \"M62 P0\" --pass-end \"M63 P0\""));
  }
}

/** The work offset must be one of every control that gets a program. */
void
checkOffset(const ProgramJob& program, const std::vector<std::string>& outputs)
{
  const std::string& offset = program.header.work_offset;
  for (const std::string& output : outputs)
    if (isProgram(output) && !offset.empty())
      if (const Diagnostic fault = faultOfOffset(languageOf(program, output), offset); !fault.empty())
        throw UsageError(Diagnostic("-o ", output, ": --work-offset ", readableText(offset), " ", fault));
}

} // namespace

bool
isProgram(const std::string& output)
{
  return isProgramExtension(extensionOf(output));
}

Dialect
languageOf(const ProgramJob& program, const std::string& output)
{
  return dialectOfExtension(extensionOf(output)).value_or(program.dialect);
}

bool
isExchange(const std::string& output)
{
  const std::string extension = extensionOf(output);
  return extension == ".apt" || extension == ".cls" || extension == ".yaml";
}

bool
hasExchange(const std::vector<std::string>& outputs)
{
  return std::any_of(outputs.begin(), outputs.end(), isExchange);
}

bool
hasProgram(const ProgramJob& program, const std::vector<std::string>& outputs)
{
  return !program.machine_file.empty() || std::any_of(outputs.begin(), outputs.end(), isProgram);
}

bool
hasLeads(const ProgramJob& program, const std::vector<std::string>& outputs)
{
  return hasProgram(program, outputs) || hasExchange(outputs);
}

void
checkProgram(const ProgramJob& program, const std::vector<std::string>& outputs, const std::set<std::string>& given)
{
  const ProgramSettings& s = program.settings;
  for (const std::string& output : outputs) {
    if (!isProgram(output))
      continue;
    const Diagnostic missing = missingFor(output, !program.machine_file.empty(), given.count("dialect") > 0, program.header.tool);
    if (!missing.empty())
      throw UsageError(Diagnostic("-o ", output, ": ", missing));
  }
  AskedNames asked = askedNames(given);
  if (!program.machine_file.empty())
    for (const char* shown : {"stay_down", "gains"}) // by the machine's picture and time
      asked.erase(shown);
  requireUsed(idleOfProgram(asked, outputs, program.dialect));
  requireOption(s.block.tip >= BlockTolerance::least_tip, "block-tolerance", s.block.tip, "must be 0.0001 mm or more");
  requireOption(s.block.axis >= BlockTolerance::least_axis, "block-tolerance", s.block.axis * in_degrees,
                "must be 0.00006 degrees or more");
  requireOption(s.thinning.tip >= 0.0, "thin-blocks", s.thinning.tip, "must not be below 0 mm");
  requireOption(s.thinning.axis >= 0.0, "thin-blocks", s.thinning.axis * in_degrees, "must not be below 0 degrees");
  requireOption(program.smoothing.value_or(0.0) >= 0.0, "smoothing", program.smoothing.value_or(0.0), "must not be below 0 mm");
  checkOffset(program, outputs);
  checkCodes(program.header, std::any_of(outputs.begin(), outputs.end(), isProgram), given);
}
