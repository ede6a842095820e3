// SPDX-License-Identifier: BSD-3-Clause
#include "post_check.h"

#include "post_text.h"

#include "io/named_values.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <regex>

namespace pcl_spiral {
namespace {

constexpr std::size_t longest_line = 80; // LinuxCNC reads 255 characters per line, older controls fewer

/** Why \p line cannot be a line, with \p remedy. */
Diagnostic
faultOfText(const std::string& line, std::string_view remedy)
{
  const auto fault = [&](const Diagnostic& what) { return Diagnostic(what, std::string(remedy)); };
  if (line != plainText(line, ""))
    return fault("has a line break or a special character");
  if (line.find_first_not_of(' ') == std::string::npos)
    return fault("has only spaces");
  if (line.size() > longest_line)
    return fault(Diagnostic("has more than ", longest_line, " characters"));
  if (line.find('%') != std::string::npos)
    return fault("has %, which ends the program");
  return {};
}

/** Why the machine's axes do not suit the language. */
Diagnostic
faultOfKinematics(Dialect dialect, const Machine& machine)
{
  const std::string language = entryOf(dialect).word;
  if (machine.three_axes)
    return dialect == Dialect::FanucVectors ? Diagnostic(language, " writes tool axes, and the machine has three axes; use fanuc")
                                            : Diagnostic();
  if (!machine.rtcp && entryOf(dialect).needs_rtcp)
    return Diagnostic(language, " needs tips and tool axes, but the machine file has rtcp: false; use linuxcnc or fanuc, or rtcp: true");
  return {};
}

/** "fanuc, fanuc-ijk or siemens": the languages whose F may be in mm/min of the tip. */
std::string
feedingTip()
{
  std::vector<std::string> words;
  for (const DialectEntry& entry : dialect_entries)
    if (entry.feeds_tip)
      words.emplace_back(entry.word);
  std::string list = words.front();
  for (std::size_t i = 1; i < words.size(); ++i)
    list += (i + 1 == words.size() ? " or " : ", ") + words[i];
  return list;
}

Diagnostic
faultOfHeader(Dialect dialect, const Machine& machine, const ProgramHeader& header)
{
  if (header.decimals < 3 || header.decimals > 6)
    return Diagnostic(header.decimals, " decimals were asked for; give 3 to 6");
  for (const std::string& code : {header.pass_begin, header.pass_end})
    if (const Diagnostic fault = code.empty() ? Diagnostic() : faultOfCode(code); !fault.empty())
      return Diagnostic("the code '", plainText(code, ""), "' of a pass ", fault);
  if (const Diagnostic fault = header.work_offset.empty() ? Diagnostic() : faultOfOffset(dialect, header.work_offset); !fault.empty())
    return Diagnostic("the work offset '", plainText(header.work_offset, ""), "' ", fault);
  if (header.coolant == Coolant::Through && machine.words.through.empty())
    return "coolant through the spindle has another word on each machine; give it in the machine file, such as program: {{coolant: "
           "{{through: M88}}}}";
  const bool follows = entryOf(dialect).feeds_tip;
  if (header.feed_mode == FeedMode::PerMinute && !machine.three_axes && !(follows && machine.rtcp))
    return Diagnostic("a feed in mm/min of the tip needs ", follows ? "rtcp: true" : feedingTip(),
                      "; take inverse time, the time of each block, instead ({FeedMode})");
  return {};
}

} // namespace

Diagnostic
faultOfCode(const std::string& code)
{
  constexpr std::string_view remedy = "; give one line such as M62 P0";
  if (const Diagnostic fault = faultOfText(code, remedy); !fault.empty())
    return fault;
  for (const char* const mark : {"(", ")", ";"})
    if (code.find(mark) != std::string::npos)
      return Diagnostic("has ", std::string(mark), ", which belongs to comments", std::string(remedy));
  return {};
}

Diagnostic
faultOfShopLine(const std::string& line)
{
  Diagnostic fault = faultOfText(line, "; give one line such as M98 P9000");
  takePieces(line, [&fault](std::string_view piece, bool is_name) {
    if (!is_name || !fault.empty() || std::find(value_names.begin(), value_names.end(), piece) != value_names.end())
      return;
    fault = Diagnostic("has ", "{" + std::string(piece) + "}", ", which is no name of a value; the names are");
    for (const std::string_view name : value_names)
      fault += Diagnostic(" ", "{" + std::string(name) + "}");
  });
  return fault;
}

Diagnostic
faultOfOffset(Dialect dialect, const std::string& offset)
{
  const DialectEntry& entry = entryOf(dialect);
  return std::regex_match(offset, std::regex(entry.offsets)) ? Diagnostic()
                                                             : Diagnostic("is none of this control; give ", entry.offset_help);
}

Diagnostic
faultOfSettings(Dialect dialect, const Machine& machine, const ProgramHeader& header)
{
  const Diagnostic fault = faultOfHeader(dialect, machine, header);
  return fault.empty() ? faultOfKinematics(dialect, machine) : fault;
}

void
requireProgram(const std::string& file, Dialect dialect, const MachineProgram& program, const ProgramHeader& header)
{
  if (program.blocks.empty())
    throw FileError(file, "not written: the program has no blocks");
  if (const Diagnostic fault = faultOfSettings(dialect, program.machine, header); !fault.empty())
    throw FileError(file, Diagnostic("not written: ", fault));
  if (dialect == Dialect::FanucVectors && !program.report.unwound_at.empty()) // a vector is the same after a whole turn
    throw FileError(file, Diagnostic("not written: ", program.machine.rotary[0].letter, " turns back at its limit, and ",
                                     entryOf(dialect).word, " has no words for it; use fanuc"));
}

} // namespace pcl_spiral
