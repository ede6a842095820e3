// SPDX-License-Identifier: BSD-3-Clause
#include "support/planted_faults.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace pcl_spiral::test {
namespace {

using Lines = std::vector<std::string>;
using Edit = std::function<bool(Lines&)>;

bool
isComment(const std::string& line)
{
  return line[0] == '(' || line[0] == ';' || line[0] == 'O';
}

bool
has(const std::string& line, const std::regex& pattern)
{
  return !isComment(line) && std::regex_search(line, pattern);
}

Edit
withoutFirst(const std::string& pattern)
{
  return [shape = std::regex(pattern)](Lines& lines) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const std::string& line) { return has(line, shape); });
    if (found == lines.end())
      return false;
    lines.erase(found);
    return true;
  };
}

Edit
withoutLast(const std::string& pattern)
{
  return [shape = std::regex(pattern)](Lines& lines) {
    const auto found = std::find_if(lines.rbegin(), lines.rend(), [&](const std::string& line) { return has(line, shape); });
    if (found == lines.rend())
      return false;
    lines.erase(std::next(found).base());
    return true;
  };
}

Edit
first(const std::string& pattern, const std::string& by)
{
  return [by, shape = std::regex(pattern)](Lines& lines) {
    for (std::string& line : lines)
      if (has(line, shape)) {
        line = std::regex_replace(line, shape, by, std::regex_constants::format_first_only);
        return true;
      }
    return false;
  };
}

Edit
everywhere(const std::function<std::string(const std::string&)>& edit)
{
  return [=](Lines& lines) {
    bool changed = false;
    for (std::string& line : lines) {
      const std::string after = isComment(line) ? line : edit(line);
      changed = changed || after != line;
      line = after;
    }
    return changed;
  };
}

/** The names of two words change places in every line. */
Edit
swapped(const std::string& a, const std::string& b)
{
  return everywhere([a, b, shape_a = std::regex(" " + a + "(?=[-+.0-9])"), shape_b = std::regex(" " + b + "(?=[-+.0-9])"),
                     mark = std::regex(" @")](const std::string& line) {
    return std::regex_replace(std::regex_replace(std::regex_replace(line, shape_a, " @"), shape_b, " " + a), mark, " " + b);
  });
}

Edit
negated(const std::string& name)
{
  return everywhere([name, minus = std::regex(" " + name + "-"), plus = std::regex(" " + name + "\\+?(?=[.0-9])"),
                     mark = std::regex(" @")](const std::string& line) {
    return std::regex_replace(std::regex_replace(std::regex_replace(line, minus, " @"), plus, " " + name + "-"), mark, " " + name);
  });
}

/** The number after \p name in a line. */
bool
change(std::string& line, const std::string& name, const std::function<double(double)>& to)
{
  std::smatch found;
  if (!std::regex_search(line, found, std::regex(" " + name + "([+-]?[0-9.]+)")))
    return false;
  std::ostringstream text;
  text << std::fixed << " " << name << to(std::stod(found[1]));
  line = found.prefix().str() + text.str() + found.suffix().str();
  return true;
}

std::size_t
firstFeed(const Lines& lines)
{
  static const std::regex feed("^(G1 |LN .* F[0-9])");
  const auto found = std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return has(line, feed); });
  return static_cast<std::size_t>(found - lines.begin());
}

bool
throughThePart(Lines& lines)
{
  static const std::regex rapid("^G0 |FMAX");
  for (std::size_t i = std::min(firstFeed(lines), lines.size() - 1); i > 0; --i)
    if (has(lines[i], rapid))
      return change(lines[i], "Z", [](double z) { return z - 40.0; });
  return false;
}

Edit
feedTimes(double factor)
{
  return [=](Lines& lines) {
    const std::size_t at = firstFeed(lines) + 3;
    return at < lines.size() && change(lines[at], "F", [=](double f) { return factor * f; });
  };
}

/** The line with \p moved goes before the first with \p before. */
Edit
earlier(const std::string& moved, const std::string& before)
{
  return [later = std::regex(moved), sooner = std::regex(before)](Lines& lines) {
    const auto lineWith = [&](const std::regex& shape) {
      return std::find_if(lines.begin(), lines.end(), [&](const std::string& line) { return has(line, shape); });
    };
    const auto from = lineWith(later), to = lineWith(sooner);
    if (from == lines.end() || to >= from)
      return false;
    std::rotate(to, from, std::next(from));
    return true;
  };
}

/** Words of a control for what all of them have. */
struct Vocabulary {
  std::string tool_tip_on, tool_tip_off, offset, other_offset, rotary_start, end;
  std::vector<std::string> direction; ///< words of the tool's direction; empty: rotary letters
};

Vocabulary
vocabularyOf(Dialect dialect)
{
  switch (dialect) {
  case Dialect::LinuxCNC:
    return {"^M428", "^M429", "G54", "G55", "^G0 [ABC]", "^M2$", {}};
  case Dialect::Fanuc:
    return {"^G43\\.4", "^G49$", "G54", "G55", "^G0 [ABC]", "^M30$", {}};
  case Dialect::FanucVectors:
    return {"^G43\\.5", "^G49$", "G54", "G55", "^G0 [ABC]", "^M30$", {"I", "J", "K"}};
  case Dialect::Siemens:
    return {"^TRAORI", "^TRAFOOF", "G54", "G55", "^G0 [ABC]", "^M30$", {"A3=", "B3=", "C3="}};
  default:
    return {"^M128", "^M129", "Q339=\\+1", "Q339=+2", "^L [ABC]", "^M30$", {"TX", "TY", "TZ"}};
  }
}

} // namespace

std::vector<PlantedFault>
plantedFaults(Dialect dialect, const std::string& rotary_letters)
{
  const Vocabulary words = vocabularyOf(dialect);
  const bool klartext = dialect == Dialect::Heidenhain;
  const std::string a = words.direction.empty() ? rotary_letters.substr(0, 1) : words.direction[0];
  const std::string b = words.direction.empty() ? rotary_letters.substr(1, 1) : words.direction[1];
  std::vector<PlantedFault> faults = {
      {"spindle not started", klartext ? withoutFirst("^M3$") : first(" M3$", ""), "a feed move with the spindle off"},
      {"spindle speed missing", first(" ?S12000", ""), "the spindle is started without a speed"},
      {"another spindle speed", first("S12000", "S1200"), "the spindle speed is 1200, but the job has 12000"},
      {"spindle backwards", first("M3$", "M4"), "the spindle turns the wrong way"},
      {"coolant not on", withoutFirst("^M8$"), "a feed move without the coolant M8"},
      {"another work offset", first(words.offset, words.other_offset), "but the part is at"},
      {"another tool", first("(T|TOOL CALL )3 ", "$014 "), "is called, but the job has tool 3"},
      {"tool-tip control not on", withoutFirst(words.tool_tip_on), "without "},
      {"tool-tip control before the rotary axes turn", earlier(words.tool_tip_on, words.rotary_start), "X Y Z swing"},
      {"tool-tip control not off", withoutLast(words.tool_tip_off), "in the machine's frame under tool-tip control"},
      {"spindle left on", withoutLast("^M5$"), "ends with the spindle on"},
      {"coolant left on", withoutLast("^M9$"), "ends with the coolant on"},
      {"no retract at the begin", withoutFirst("G53|SUPA|M91"), "below the retract height"},
      {"no retract at the end", withoutLast("G53|SUPA|M91"), "ends below the retract height"},
      {"no end", withoutLast(words.end), "the text ends before the program does"},
      {"a feed missing", [](Lines& lines) { return first(" FT?[0-9.]+", "")(lines); }, "a feed move without F"},
      {"two words of the tool's direction swapped", swapped(a, b), {}},
      {"a sign of the tool's direction wrong", negated(b), {}},
      {"a rapid through the part", throughThePart, "a rapid enters the part by "},
      {"a feed of a hundred times", feedTimes(100.0), "/min, but "},
      {"a word that no control has", first("^M8$", "G199"), "unknown "}};
  if (!klartext) {
    faults.push_back({"inches", first("G[27]1 ", dialect == Dialect::Siemens ? "G70 " : "G20 "), "units are inches"});
    faults.push_back({"no inverse time", withoutFirst("^G93$"), {}});
  }
  if (dialect == Dialect::LinuxCNC)
    faults.push_back({"tool length not counted", withoutFirst("^G43"), "without a tool length"});
  if (dialect == Dialect::Siemens) {
    faults.push_back({"tool length not counted", first(" D1$", ""), "without a tool length"});
    const std::regex off(" D0$");
    faults.push_back({"tool length counted in the retract",
                      everywhere([off](const std::string& line) { return std::regex_replace(line, off, ""); }), "D0 is missing"});
  }
  if (dialect == Dialect::Fanuc || dialect == Dialect::FanucVectors)
    faults.push_back({"length of another tool", first(" H3 ", " H4 "), "the tool length of H4, but the tool is 3"});
  return faults;
}

std::string
withFault(const std::string& text, Dialect dialect, const PlantedFault& fault)
{
  const bool numbered = dialect == Dialect::Heidenhain;
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(numbered ? line.substr(line.find(' ') + 1) : line);
  if (!fault.plant(lines))
    return {};
  std::string planted;
  for (std::size_t i = 0; i < lines.size(); ++i)
    planted += (numbered ? std::to_string(i) + " " : std::string()) + lines[i] + "\n";
  return planted;
}

} // namespace pcl_spiral::test
