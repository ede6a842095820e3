// SPDX-License-Identifier: BSD-3-Clause
#include "control_program.h"
#include "text_encoding.h"
#include "text_scan.h"

#include "io/byte_file.h"
#include "io/kinematics_text.h"
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/program_reader.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

/** The language of a program by words that only it has. */
Dialect
dialectOf(std::string_view text)
{
  const auto has = [text](std::string_view word) { return text.find(word) != std::string_view::npos; };
  if (has("BEGIN PGM"))
    return Dialect::Heidenhain;
  if (has("TRAORI") || has("A3=") || has("SUPA"))
    return Dialect::Siemens;
  if (has("G43.5"))
    return Dialect::FanucVectors;
  return trimmed(text.substr(0, 1)) == "%" || has("G43.4") ? Dialect::Fanuc : Dialect::LinuxCNC;
}

/** Refuses a machine whose kinematics are not those that the program's own comment names. */
void
requireMadeFor(const std::string& file, std::string_view text, const Machine& machine)
{
  const std::size_t begin = text.find(kinematics_opening);
  if (begin == std::string_view::npos)
    return;
  const std::size_t end = std::min(text.size(), text.find_first_of(")\r\n", begin));
  const std::string made_for(trimmed(text.substr(begin, end - begin)));
  if (made_for == kinematicsText(machine))
    return;
  const auto line = static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n') + 1);
  throw FileError(file,
                  atLine(line, Diagnostic("the comment says that the program was made for a machine '", made_for, "', but ", machine.name,
                                          " is '", kinematicsText(machine), "'; give the machine file for which it was made")));
}

} // namespace

ProgramFile
readProgram(const std::string& file, const std::optional<Machine>& machine, std::optional<Dialect> dialect)
{
  const std::string extension = lowerExtension(file), bytes = readBytes(file);
  refuseWideText(file, bytes);
  const std::string text = bytes.substr(utf8Mark(bytes));
  if (extension == ".apt" || extension == ".cls") {
    ProgramFile result = readAPT(file, text, machine.value_or(xyzacTrunnion()), machine.has_value());
    result.language = "apt";
    return result;
  }
  if (!machine)
    throw FileError(file, "a program has the axes of a machine; give its machine file");
  requireMadeFor(file, text, *machine);
  const std::optional<Dialect> by_name = dialect ? dialect : dialectOfExtension(extension);
  const Dialect language = by_name ? *by_name : dialectOf(text);
  ProgramFile result = language == Dialect::Heidenhain ? readKlartext(file, text, *machine) : readGCode(file, text, *machine, language);
  result.language = entryOf(language).word;
  result.control = entryOf(language).control;
  return result;
}

} // namespace pcl_spiral
