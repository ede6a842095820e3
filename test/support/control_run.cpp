// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_run.h"

#include "support/control_languages.h"

#include <cctype>
#include <sstream>

namespace pcl_spiral::test {
namespace {

std::unique_ptr<ControlLanguage>
languageOf(Dialect dialect, Control& control)
{
  switch (dialect) {
  case Dialect::LinuxCNC:
    return linuxCNC(control);
  case Dialect::Siemens:
    return siemens(control);
  case Dialect::Heidenhain:
    return klartext(control);
  default:
    return fanuc(control);
  }
}

std::string
trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(" \r");
  return begin == std::string::npos || end < begin ? std::string() : text.substr(begin, end - begin + 1);
}

/** \p line without comments. */
std::string
plain(std::string line, Dialect dialect)
{
  const bool round = dialect == Dialect::LinuxCNC || dialect == Dialect::Fanuc || dialect == Dialect::FanucVectors;
  while (round && line.find('(') != std::string::npos) {
    const std::size_t open = line.find('('), close = line.find(')');
    if (close == std::string::npos || close < open || line.find('(', open + 1) < close)
      throw ControlFault("a comment that does not end");
    line.erase(open, close - open + 1);
  }
  if (dialect != Dialect::Fanuc && dialect != Dialect::FanucVectors)
    line = line.substr(0, line.find(';'));
  return trimmed(line);
}

/** Takes the number of a line off: N10, or of Klartext, whose lines count from 0. */
std::string
withoutNumber(const std::string& line, Dialect dialect, long& last)
{
  const bool klartext = dialect == Dialect::Heidenhain;
  const std::size_t begin = !klartext && !line.empty() && line[0] == 'N' ? 1 : 0;
  if (begin == 0 && !klartext)
    return line;
  std::size_t end = begin;
  while (end < line.size() && std::isdigit(static_cast<unsigned char>(line[end])))
    ++end;
  if (end == begin)
    throw ControlFault("no line number");
  const long number = std::stol(line.substr(begin, end - begin));
  if (klartext ? number != last + 1 : number <= last)
    throw ControlFault("line numbers do not count on");
  last = number;
  return trimmed(line.substr(end));
}

} // namespace

ControlRun
runProgram(const std::string& text, Dialect dialect, const ControlJob& job)
{
  Control control(job);
  const std::unique_ptr<ControlLanguage> language = languageOf(dialect, control);
  ControlRun run;
  std::istringstream stream(text);
  std::string line;
  try {
    for (long number = -1; std::getline(stream, line);) {
      ++control.line;
      for (const char c : line)
        if (c < ' ' || c > '~')
          throw ControlFault("a character that controls do not read");
      const std::string words = withoutNumber(trimmed(line), dialect, number);
      if (job.hooks.count(words) > 0)
        run.hooks.emplace_back(words, control.motions.size());
      else if (const std::string left = plain(words, dialect); !left.empty())
        language->run(left);
    }
    line = "the end";
    language->end();
    control.requireEnd();
  }
  catch (const std::runtime_error& fault) {
    run.fault = "line " + std::to_string(control.line) + " '" + line.substr(0, 100) + "': " + fault.what();
  }
  run.motions = std::move(control.motions);
  return run;
}

} // namespace pcl_spiral::test
