// SPDX-License-Identifier: BSD-3-Clause
#include "support/program_parsers.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace pcl_spiral::test {
namespace {

std::vector<std::string>
linesOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/** A plain decimal number, with a point and nothing else. */
double
decimal(const std::string& text)
{
  static const std::regex shape("[+-]?[0-9]+(\\.[0-9]+)?");
  if (!std::regex_match(text, shape))
    throw std::runtime_error("no decimal number: " + text);
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return value;
}

/** Words of a line with their values; a word is the text before the first sign, digit or =. */
std::map<std::string, double>
wordsOf(const std::string& line, bool equals)
{
  std::map<std::string, double> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) {
    std::size_t at = word.find_first_of("+-0123456789");
    const std::size_t sign = word.find('=');
    if (equals && sign != std::string::npos)
      at = sign + 1;
    const std::string name = word.substr(0, equals && sign != std::string::npos ? sign : at);
    if (at == std::string::npos)
      words[word] = 0.0;
    else if (!words.emplace(name, decimal(word.substr(at))).second)
      throw std::runtime_error("a word twice: " + line);
  }
  return words;
}

void
takePlace(ParsedMove& move, const std::map<std::string, double>& words)
{
  move.xyz = {words.at("X"), words.at("Y"), words.at("Z")};
  for (char letter : {'A', 'B', 'C'})
    if (const auto found = words.find(std::string(1, letter)); found != words.end())
      move.degrees[letter] = found->second;
}

std::optional<Eigen::Vector3d>
vectorOf(const std::map<std::string, double>& words, const std::string& x, const std::string& y, const std::string& z)
{
  if (words.count(x) + words.count(y) + words.count(z) == 0)
    return std::nullopt;
  return Eigen::Vector3d(words.at(x), words.at(y), words.at(z));
}

/** A move to X Y Z that begins with one of \p codes. */
bool
namesPlace(const std::string& line, const std::vector<std::string>& codes)
{
  return line.find(" X") != std::string::npos && line.find(" Z") != std::string::npos &&
         std::any_of(codes.begin(), codes.end(), [&line](const std::string& code) { return line.rfind(code, 0) == 0; });
}

} // namespace

bool
ParsedProgram::has(const std::string& line) const
{
  return std::find(others.begin(), others.end(), line) != others.end();
}

void
ParsedProgram::addOther(const std::string& line)
{
  others.push_back(line);
  moves_before.push_back(moves.size());
}

std::vector<std::size_t>
ParsedProgram::placesOf(const std::string& line) const
{
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < others.size(); ++i)
    if (others[i] == line)
      places.push_back(moves_before[i]);
  return places;
}

ParsedProgram
parseFanuc(const std::string& file)
{
  ParsedProgram program;
  bool inverse_time = false;
  for (const std::string& line : linesOf(file)) {
    inverse_time = line == "G93" || (inverse_time && line != "G94");
    if (!namesPlace(line, {"G0 ", "G1 "})) {
      program.addOther(line);
      continue;
    }
    const auto words = wordsOf(line, false);
    ParsedMove move;
    move.rapid = words.at("G") == 0.0;
    takePlace(move, words);
    move.vector = vectorOf(words, "I", "J", "K");
    if (!move.rapid && !inverse_time)
      throw std::runtime_error("a feed outside of G93: " + line);
    if (!move.rapid)
      move.minutes = 1.0 / words.at("F");
    program.moves.push_back(move);
  }
  return program;
}

ParsedProgram
parseSiemens(const std::string& file)
{
  ParsedProgram program;
  for (const std::string& line : linesOf(file)) {
    if (!namesPlace(line, {"G0 ", "G1 "})) {
      program.addOther(line);
      continue;
    }
    const auto words = wordsOf(line, true);
    ParsedMove move;
    move.rapid = words.at("G") == 0.0;
    takePlace(move, words);
    move.vector = vectorOf(words, "A3", "B3", "C3");
    if (!move.rapid)
      move.minutes = 1.0 / words.at("F");
    program.moves.push_back(move);
  }
  return program;
}

ParsedProgram
parseHeidenhain(const std::string& file)
{
  ParsedProgram program;
  std::size_t number = 0;
  for (const std::string& line : linesOf(file)) {
    const std::size_t space = line.find(' ');
    if (decimal(line.substr(0, space)) != static_cast<double>(number++))
      throw std::runtime_error("lines do not count on: " + line);
    const std::string text = line.substr(space + 1);
    if (!namesPlace(text, {"LN ", "L "})) {
      program.addOther(text);
      continue;
    }
    const auto words = wordsOf(text.substr(text.find(' ') + 1), false);
    ParsedMove move;
    move.rapid = words.count("FMAX") > 0;
    takePlace(move, words);
    move.vector = vectorOf(words, "TX", "TY", "TZ");
    move.normal = vectorOf(words, "NX", "NY", "NZ");
    if (!move.rapid) {
      move.feed = words.at("F");
      move.minutes = (move.xyz - program.moves.back().xyz).norm() / move.feed;
    }
    program.moves.push_back(move);
  }
  return program;
}

std::vector<AptMove>
parseAPT(const std::string& file, std::vector<std::string>& others)
{
  std::vector<AptMove> moves;
  double feed = 0.0;
  bool rapid = false;
  for (const std::string& line : linesOf(file)) {
    std::vector<std::string> values;
    std::istringstream stream(line.substr(std::min(line.size(), line.find('/') + 1)));
    for (std::string value; std::getline(stream, value, ',');)
      values.push_back(value);
    if (line.rfind("FEDRAT/", 0) == 0)
      feed = decimal(values.at(0));
    else if (line == "RAPID")
      rapid = true;
    else if (line.rfind("GOTO/", 0) == 0) {
      moves.push_back({{decimal(values.at(0)), decimal(values.at(1)), decimal(values.at(2))},
                       {decimal(values.at(3)), decimal(values.at(4)), decimal(values.at(5))},
                       feed,
                       rapid});
      rapid = false;
    }
    else
      others.push_back(line);
  }
  return moves;
}

} // namespace pcl_spiral::test
