// SPDX-License-Identifier: BSD-3-Clause
#include "support/gcode_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pcl_spiral::test {
namespace {

using Eigen::Vector3d;
using Words = std::vector<std::pair<char, std::string>>;

/** The words of a line without its comments: a letter and a number each. */
Words
wordsOf(const std::string& line)
{
  Words words;
  bool comment = false;
  for (const char c : line) {
    comment = c == '(' || (comment && c != ')');
    if (c == ';' || c == '%')
      break;
    if (comment || c == ')' || std::isspace(static_cast<unsigned char>(c)))
      continue;
    if (std::isalpha(static_cast<unsigned char>(c)))
      words.emplace_back(c, "");
    else if (words.empty())
      throw std::runtime_error("a number without a letter: " + line);
    else
      words.back().second += c;
  }
  return words;
}

/** Tool for axis values without tip control; a machine without rotary axes keeps its axis. */
TipAndAxis
machinePlace(const MachineChain& chain, const AxisValues& at)
{
  return chain.rotary.empty() ? TipAndAxis{at.xyz, Vector3d::UnitZ()} : forward(chain, at);
}

/** X Y Z without tip control that put the tip at \p tip: the tip is linear in them. */
Vector3d
axesFor(const MachineChain& chain, const Vector3d& tip, AxisValues at)
{
  at.xyz.setZero();
  const Vector3d shift = machinePlace(chain, at).tip;
  Eigen::Matrix3d turn;
  for (int k = 0; k < 3; ++k) {
    at.xyz = Vector3d::Unit(k);
    turn.col(k) = machinePlace(chain, at).tip - shift;
  }
  return turn.inverse() * (tip - shift);
}

class GcodeControl {
public:
  explicit GcodeControl(const ControlledMachine& machine) : machine_(machine), tip_control_(machine.tip_control == TipControl::Kinematics)
  {
    at_.xyz.setConstant(unknown);
    at_.first = at_.second = machine.chain.rotary.empty() ? 0.0 : unknown;
  }

  void run(std::size_t line, const Words& words)
  {
    bool machine_frame = false, moves = false;
    for (const auto& [letter, number] : words) // the modes of a block come before its move
      if (letter == 'G' && number == "53")
        machine_frame = true;
      else if (letter == 'G' && (number == "0" || number == "1"))
        rapid_ = number == "0";
      else if (machine_.tip_control == TipControl::Length && letter == 'G' && (number == "43.4" || number == "49"))
        setTipControl(number == "43.4");
      else if (machine_.tip_control == TipControl::Kinematics && letter == 'M' && (number == "428" || number == "429"))
        setTipControl(number == "428");
      else if (letter == 'G' && known_codes.count(number) == 0)
        throw std::runtime_error("G" + number + " is not known");
    AxisValues to = at_;
    for (const auto& [letter, number] : words)
      if (double* value = valueOf(letter, to)) {
        *value = std::stod(number);
        moves = true;
      }
      else if (std::string("GMFSTHPONDQ").find(letter) == std::string::npos)
        throw std::runtime_error(std::string(1, letter) + number + " is not known");
    if (!moves)
      return;
    if (machine_frame && tip_control_)
      throw std::runtime_error("machine coordinates with tip control");
    if (machine_frame) // of the gauge point
      for (int k = 0; k < 3; ++k)
        if (to.xyz[k] != at_.xyz[k])
          to.xyz[k] -= machine_.chain.work_zero[k] + (k == 2 ? machine_.chain.tool_length : 0.0);
    if (isKnown(at_) && isKnown(to))
      moves_.push_back({line, rapid_, tip_control_, at_, to});
    at_ = to;
  }

  std::vector<AxisMove> takeMoves() { return std::move(moves_); }

private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  static const std::set<std::string> known_codes; ///< units, plane, offsets off, feed modes, smoothing, the first work offset

  static bool isKnown(const AxisValues& at) { return at.xyz.allFinite() && std::isfinite(at.first) && std::isfinite(at.second); }

  double* valueOf(char letter, AxisValues& at) const
  {
    if (letter >= 'X' && letter <= 'Z')
      return &at.xyz[letter - 'X'];
    for (std::size_t i = 0; i < machine_.chain.rotary.size(); ++i)
      if (machine_.chain.rotary[i].letter == letter)
        return i == 0 ? &at.first : &at.second;
    return nullptr;
  }

  /** The tool stays where it is; its coordinates are other ones from now on. */
  void setTipControl(bool on)
  {
    if (on != tip_control_ && isKnown(at_))
      at_.xyz = on ? machinePlace(machine_.chain, at_).tip : axesFor(machine_.chain, at_.xyz, at_);
    tip_control_ = on;
  }

  const ControlledMachine& machine_;
  bool tip_control_, rapid_ = true;
  AxisValues at_;
  std::vector<AxisMove> moves_;
};

const std::set<std::string> GcodeControl::known_codes{"5.1", "17", "21", "40", "43", "49", "54", "61", "64", "80", "90", "93", "94"};

} // namespace

TipAndAxis
placeOn(const ControlledMachine& machine, const AxisMove& move, double share)
{
  const auto mix = [share](auto from, auto to) { return from + share * (to - from); };
  const AxisValues at{move.from.xyz + share * (move.to.xyz - move.from.xyz), mix(move.from.first, move.to.first),
                      mix(move.from.second, move.to.second)};
  TipAndAxis place = machinePlace(machine.chain, at);
  if (move.tip_control)
    place.tip = at.xyz;
  place.tip -= machine.longer_tool * place.axis;
  return place;
}

std::vector<AxisMove>
movesOf(const std::string& text, const ControlledMachine& machine)
{
  GcodeControl control(machine);
  std::istringstream stream(text);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);)
    try {
      control.run(++number, wordsOf(line));
    }
    catch (const std::runtime_error& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what() + ": " + line);
    }
  return control.takeMoves();
}

void
followMoves(const std::vector<AxisMove>& moves, const ControlledMachine& machine, double step,
            const std::function<void(const TipAndAxis&)>& visit)
{
  constexpr double turn = 1.0; // degrees
  for (const AxisMove& move : moves) {
    const double way = (placeOn(machine, move, 1.0).tip - placeOn(machine, move, 0.0).tip).norm();
    const double turned = std::max(std::abs(move.to.first - move.from.first), std::abs(move.to.second - move.from.second));
    const int parts = std::max(1, static_cast<int>(std::ceil(std::max(way / step, turned / turn))));
    for (int i = &move == &moves.front() ? 0 : 1; i <= parts; ++i)
      visit(placeOn(machine, move, static_cast<double>(i) / parts));
  }
}

} // namespace pcl_spiral::test
