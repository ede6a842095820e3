// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_state.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl_spiral::test {
namespace {

constexpr double uneven = 2.0; ///< within a block between two vectors the control slows down where an axis would be too fast

template <typename... Parts>
[[noreturn]] void
refuse(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw ControlFault(text.str());
}

void
require(bool holds, const std::string& fault)
{
  if (!holds)
    throw ControlFault(fault);
}

} // namespace

Control::Control(const ControlJob& job) : job_(job)
{
  constexpr double below = 20.0; // so that the program has to retract
  at_.gauge.z() = job.retract_z ? *job.retract_z - below : job.real.work_zero.z() + job.real.tool_length + 300.0;
}

void
Control::callTool(int number)
{
  require(!modal.tool_tip, "a tool change under tool-tip control");
  require(!job_.retract_z || at_.gauge.z() > *job_.retract_z - 1e-3, "a tool change below the retract height");
  if (number != job_.tool)
    refuse("tool ", number, " is called, but the job has tool ", job_.tool);
  modal.tool = number;
  modal.spindle = 0;
  modal.coolant.clear();
}

void
Control::requireLengthOf(int number) const
{
  if (number != std::max(1, job_.tool))
    refuse("the tool length of H", number, ", but the tool is ", job_.tool);
}

void
Control::startSpindle(int direction)
{
  require(modal.spindle_speed > 0.0, "the spindle is started without a speed");
  require(job_.tool == 0 || modal.tool == job_.tool, "the spindle is started before the tool is called");
  if (std::abs(modal.spindle_speed - job_.spindle_speed) > 0.5)
    refuse("the spindle speed is ", modal.spindle_speed, ", but the job has ", job_.spindle_speed);
  require((direction > 0) == job_.clockwise, "the spindle turns the wrong way");
  modal.spindle = direction;
}

void
Control::chooseOffset(const std::string& word)
{
  require(word == job_.offset, "work offset " + word + ", but the part is at " + job_.offset);
  modal.offset = true;
}

void
Control::requireMetric(bool metric)
{
  require(metric, "units are inches");
  modal.metric = true;
}

void
Control::setToolTip(bool on, bool vectors)
{
  require(!on || modal.offset, "tool-tip control without a work offset");
  require(!on || modal.length, "tool-tip control without a tool length");
  require(job_.tool_tip || !on, "tool-tip control on a machine that has none");
  first_under_tip_ = on && !modal.tool_tip;
  modal.tool_tip = on;
  modal.vectors = on && vectors;
}

void
Control::requireReady(const MotionWords& words, bool rapid) const
{
  require(!modal.ended, "motion after the end of the program");
  require(modal.metric && modal.absolute && modal.plane_xy, "motion before units, absolute words and the plane are set");
  require(!words.machine_frame || !modal.tool_tip, "a move in the machine's frame under tool-tip control");
  require(!words.vector || (modal.tool_tip && modal.vectors), "a tool vector without tool-tip control");
  const bool xyz = words.xyz[0] || words.xyz[1] || words.xyz[2];
  if (!words.machine_frame) {
    require(!xyz || modal.offset, "motion without a work offset");
    require(!words.xyz[2] || modal.length, "motion of Z without a tool length");
  }
  if (rapid)
    return;
  require(!words.machine_frame, "a feed move in the machine's frame");
  require(modal.spindle != 0, "a feed move with the spindle off");
  require(job_.coolant.empty() || modal.coolant.count(job_.coolant) > 0, "a feed move without the coolant " + job_.coolant);
  require(!job_.tool_tip || modal.tool_tip, "a feed move without tool-tip control");
  require(modal.feed_mode, "a feed move before G93 or G94");
  require(words.minutes || words.feed, "a feed move without F");
}

AxisPosition
Control::target(const MotionWords& words) const
{
  AxisPosition to = at_;
  for (const auto& [letter, degrees] : words.degrees) {
    const auto& axes = job_.set.rotary;
    const auto axis = std::find_if(axes.begin(), axes.end(), [l = letter](const ChainRotary& a) { return a.letter == l; });
    if (axis == axes.end())
      refuse("the machine has no axis ", letter);
    to.degrees[axis - axes.begin()] = degrees;
  }
  if (words.vector)
    to.degrees = nearestAngles(job_.set, words.vector->normalized(), at_.degrees);
  const auto replaced = [&words](Eigen::Vector3d xyz) {
    for (int i = 0; i < 3; ++i)
      xyz[i] = words.xyz[i].value_or(xyz[i]);
    return xyz;
  };
  if (words.machine_frame)
    to.gauge = replaced(at_.gauge);
  else if (modal.tool_tip)
    to.gauge = gaugeFor(job_.set, replaced(toolAt(job_.set, at_).tip), to.degrees);
  else {
    const Eigen::Vector3d zero = job_.set.work_zero + Eigen::Vector3d(0.0, 0.0, modal.length ? job_.set.tool_length : 0.0);
    to.gauge = replaced(at_.gauge - zero) + zero;
  }
  return to;
}

AxisPosition
Control::onTheWay(const MotionWords& words, const AxisPosition& from, const AxisPosition& to, const AxisPosition& before,
                  double share) const
{
  AxisPosition at;
  for (int i = 0; i < 2; ++i)
    at.degrees[i] = from.degrees[i] + share * (to.degrees[i] - from.degrees[i]);
  if (!modal.tool_tip) {
    at.gauge = from.gauge + share * (to.gauge - from.gauge);
    return at;
  }
  const TipAndAxis a = toolAt(job_.set, from), b = toolAt(job_.set, to);
  if (words.vector && words.great_circle && share < 1.0)
    at.degrees = nearestAngles(
        job_.set, Eigen::Quaterniond::Identity().slerp(share, Eigen::Quaterniond::FromTwoVectors(a.axis, b.axis)) * a.axis, before.degrees);
  at.gauge = gaugeFor(job_.set, a.tip + share * (b.tip - a.tip), at.degrees);
  return at;
}

double
Control::minutesOf(const MotionWords& words, const AxisPosition& from, const AxisPosition& to) const
{
  const double tip = modal.tool_tip ? (toolAt(job_.set, to).tip - toolAt(job_.set, from).tip).norm() : (to.gauge - from.gauge).norm();
  const double turn = std::hypot(to.degrees[0] - from.degrees[0], to.degrees[1] - from.degrees[1]);
  const double given = words.minutes ? 1.0 / *words.minutes : *words.feed;
  require(given > 0.0 && std::isfinite(given), "F is not above zero");
  return words.minutes ? *words.minutes : (tip > 1e-6 ? tip : turn) / *words.feed;
}

void
Control::requireSpeeds(const AxisPosition& from, const AxisPosition& to, double minutes, double excess) const
{
  constexpr double rounding = 1.02; // of F and of the words
  const auto check = [&](char axis, double way, double largest, const char* unit) {
    if (std::abs(way) > rounding * excess * minutes * largest + 2e-4) // and of the places
      refuse(axis, " at ", std::abs(way) / minutes, unit, ", but its largest speed is ", largest);
  };
  for (int i = 0; i < 3; ++i)
    check("XYZ"[i], to.gauge[i] - from.gauge[i], job_.linear[i].largest_speed, " mm/min");
  for (std::size_t i = 0; i < job_.real.rotary.size(); ++i)
    check(job_.real.rotary[i].letter, to.degrees[i] - from.degrees[i], job_.rotary[i].largest_speed, " degrees/min");
  const double way = (toolAt(job_.real, to).tip - toolAt(job_.real, from).tip).norm();
  if (way > rounding * minutes * job_.largest_feed + 2e-4)
    refuse("the tip at ", way / minutes, " mm/min, but the largest feed is ", job_.largest_feed);
}

void
Control::requireTravel(const AxisPosition& at) const
{
  const auto check = [](char axis, double value, const AxisTravel& travel) {
    if (value < travel.lower - 1e-3 || value > travel.upper + 1e-3)
      refuse(axis, " at ", value, ", beyond its travel of ", travel.lower, " to ", travel.upper);
  };
  for (int i = 0; i < 3; ++i)
    check("XYZ"[i], at.gauge[i], job_.linear[i]);
  for (std::size_t i = 0; i < job_.real.rotary.size(); ++i)
    check(job_.real.rotary[i].letter, at.degrees[i], job_.rotary[i]);
}

void
Control::requireClear(const AxisPosition& at, bool rapid) const
{
  const TipAndAxis tool = toolAt(job_.real, at);
  const double clearance = job_.clearance(tool);
  if (rapid ? clearance < 0.0 : clearance < -job_.gouge)
    refuse(rapid ? "a rapid" : "a feed move", " enters the part by ", -clearance, " mm with the tip at ", tool.tip.transpose());
}

void
Control::requireNoSwing(const AxisPosition& from, const AxisPosition& to) const
{
  const double turn = std::max(std::abs(to.degrees[0] - from.degrees[0]), std::abs(to.degrees[1] - from.degrees[1]));
  if (modal.tool_tip && !cut_ && turn > 5.0)
    refuse("X Y Z swing: a rotary axis turns by ", turn, " degrees under tool-tip control before the first cut");
  const double height = job_.retract_z.value_or(-std::numeric_limits<double>::infinity());
  if (!modal.tool_tip && job_.tool_tip && turn > 1e-6 && std::min(from.gauge.z(), to.gauge.z()) < height - 1e-3)
    refuse("a rotary axis turns below the retract height without tool-tip control");
  if (first_under_tip_ && job_.retract_z && (to.gauge - from.gauge).head<2>().norm() > job_.first_step)
    refuse("the first block under tool-tip control moves X Y by ", (to.gauge - from.gauge).head<2>().transpose());
}

void
Control::move(const MotionWords& words, bool rapid)
{
  requireReady(words, rapid);
  const AxisPosition from = at_, to = target(words);
  requireNoSwing(from, to);
  const double minutes = rapid ? 0.0 : minutesOf(words, from, to);
  const double way = std::max((to.gauge - from.gauge).norm(), (toolAt(job_.real, to).tip - toolAt(job_.real, from).tip).norm());
  const double turn = std::max(std::abs(to.degrees[0] - from.degrees[0]), std::abs(to.degrees[1] - from.degrees[1]));
  const int steps = std::max(2, static_cast<int>(std::ceil(std::max(way / 2.0, turn / 3.0))));
  for (int i = 1; i <= steps; ++i) {
    const AxisPosition next = onTheWay(words, from, to, at_, static_cast<double>(i) / steps);
    if (!rapid)
      requireSpeeds(at_, next, minutes / steps, words.vector && words.great_circle ? uneven : 1.0);
    requireTravel(next);
    requireClear(next, rapid);
    at_ = next;
  }
  cut_ = cut_ || !rapid;
  first_under_tip_ = false;
  motions.push_back({line, rapid, modal.tool_tip, minutes, at_.gauge, at_.degrees, toolAt(job_.real, at_)});
}

void
Control::requireEnd() const
{
  require(modal.ended, "the text ends before the program does");
  require(!modal.tool_tip, "the program ends under tool-tip control");
  require(modal.spindle == 0, "the program ends with the spindle on");
  require(modal.coolant.empty(), "the program ends with the coolant on");
  require(!modal.inverse_time, "the program ends in inverse time");
  require(!modal.smoothing, "the program ends with smoothing on");
  require(!job_.retract_z || at_.gauge.z() > *job_.retract_z - 1e-3, "the program ends below the retract height");
}

} // namespace pcl_spiral::test
