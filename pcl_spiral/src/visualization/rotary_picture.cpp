// SPDX-License-Identifier: BSD-3-Clause
#include "sheet.h"

#include "box_axes.h"
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/visualization/pass_picture.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl_spiral {
namespace {

using Boxes = std::vector<std::array<Eigen::Vector2d, 2>>;

constexpr double left = 150.0, right = Sheet::width - 60.0; ///< of the charts, pixels
constexpr double lowest = 110.0, chart_height = 250.0, chart_step = 330.0;
constexpr double number_room = 90.0, tick = axis_tick_length, line = 2.5;
constexpr double no_change = 1e-7; // of the axis, radians: at the pole an upright tool keeps it
constexpr Color line_color{0.10, 0.22, 0.66}, pole_color{1.00, 0.80, 0.45}, unwind_color{0.84, 0.04, 0.07};

/** A curve over the arc length; interrupted where a new pass begins. */
struct Curve {
  std::string name;
  std::vector<double> at, values;
  std::vector<bool> joined; ///< to the value before

  void add(double s, double value, bool join)
  {
    at.push_back(s);
    values.push_back(value);
    joined.push_back(join);
  }
};

/** The first two curves at the end of a block: both rotary axes; without them Z of the tip and its speed. */
std::array<double, 2>
valuesAt(const MachineProgram& program, const ProgramBlock& before, const ProgramBlock& block)
{
  if (program.machine.three_axes)
    return {block.tip.z(), (block.tip - before.tip).norm() / block.minutes};
  return {block.angles.first * in_degrees / 360.0, block.angles.second * in_degrees};
}

/** Both rotary axes at every cut, and the speed of the contact. */
std::array<Curve, 3>
curvesOf(const MachineProgram& program)
{
  const Machine& machine = program.machine;
  std::array<Curve, 3> curves;
  curves[0].name = machine.three_axes ? "Z of the tip, mm" : std::string(1, machine.rotary[0].letter) + ", turns";
  curves[1].name = machine.three_axes ? "speed of the tip, mm/min" : std::string(1, machine.rotary[1].letter) + ", degrees";
  curves[2].name = "speed of the contact, mm/min";
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    const ProgramBlock &before = program.blocks[i - 1], &block = program.blocks[i];
    if (block.section != BlockSection::Cut)
      continue;
    const bool join = before.section == BlockSection::Cut;
    if (!join && !machine.three_axes)
      for (int k : {0, 1})
        curves[k].add(before.arc_length, valuesAt(program, before, before)[k], false);
    for (int k : {0, 1})
      curves[k].add(block.arc_length, valuesAt(program, before, block)[k], join || !machine.three_axes);
    curves[2].add(block.arc_length, (block.arc_length - before.arc_length) / block.minutes, join);
  }
  return curves;
}

/** Position and range of a chart. */
struct Scale {
  double bottom, length, low, high;

  Scale(const Curve& curve, int slot, double length) : bottom(lowest + slot * chart_step), length(length)
  {
    const auto [least, most] = std::minmax_element(curve.values.begin(), curve.values.end());
    const double margin = std::max(0.05 * (*most - *least), 1e-3 * std::max(1.0, std::abs(*most)));
    low = *least - margin;
    high = *most + margin;
  }
  double x(double s) const { return left + (right - left) * s / length; }
  double y(double value) const { return bottom + chart_height * (value - low) / (high - low); }
};

/** For every column of pixels, the range of the curve in it. */
Boxes
drawn(const Curve& curve, const Scale& scale)
{
  const double none = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, double>> columns(static_cast<std::size_t>(right - left) + 1, {none, -none});
  const auto cover = [&](double x, double y) {
    auto& [least, most] = columns[static_cast<std::size_t>(std::clamp(x - left, 0.0, right - left))];
    least = std::min(least, y);
    most = std::max(most, y);
  };
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    const double x = scale.x(curve.at[i]), y = scale.y(curve.values[i]);
    const double from_x = curve.joined[i] && i > 0 ? scale.x(curve.at[i - 1]) : x;
    const double from_y = curve.joined[i] && i > 0 ? scale.y(curve.values[i - 1]) : y;
    const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * (x - from_x))));
    for (int k = 0; k <= steps; ++k)
      cover(from_x + (x - from_x) * k / steps, from_y + (y - from_y) * k / steps);
  }
  Boxes boxes;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].first <= columns[c].second) {
      const double x = left + static_cast<double>(c);
      boxes.push_back({Eigen::Vector2d(x, columns[c].first - 0.5 * line), Eigen::Vector2d(x + 1.0, columns[c].second + 0.5 * line)});
    }
  return boxes;
}

void
addAxes(vtkRenderer* view, const Curve& curve, const Scale& scale, bool numbers_below)
{
  Boxes strokes{{Eigen::Vector2d(left, scale.bottom), Eigen::Vector2d(right, scale.bottom)},
                {Eigen::Vector2d(left, scale.bottom), Eigen::Vector2d(left, scale.bottom + chart_height)}};
  const double step = niceStep((scale.high - scale.low) * 45.0 / chart_height);
  for (double k = std::ceil(scale.low / step); k * step <= scale.high; k += 1.0) {
    const double y = scale.y(k * step);
    strokes.push_back({Eigen::Vector2d(left, y), Eigen::Vector2d(left - tick, y)});
    addCentredText(view, formatted("%.6g", k == 0.0 ? 0.0 : k * step), {left - 60.0, y}, number_size);
  }
  const double along = niceStep(scale.length * number_room / (right - left));
  for (double k = 0.0; k * along <= scale.length * (1.0 + 1e-9); k += 1.0) {
    const double x = scale.x(k * along);
    strokes.push_back({Eigen::Vector2d(x, scale.bottom), Eigen::Vector2d(x, scale.bottom - tick)});
    if (numbers_below)
      addCentredText(view, formatted("%.6g", k * along), {x, scale.bottom - 26.0}, number_size);
  }
  addStrokes(view, strokes, ink, 1.5f);
  addText(view, curve.name, 40, static_cast<int>(scale.bottom + chart_height) + 14, name_size);
}

void
addPlaces(vtkRenderer* view, const MachineProgram& program, const Scale& scale)
{
  Boxes poles, unwinds;
  for (const PoleZone& zone : program.report.poles)
    poles.push_back({Eigen::Vector2d(scale.x(zone.begin), scale.bottom),
                     Eigen::Vector2d(std::max(scale.x(zone.end), scale.x(zone.begin) + 3.0), scale.bottom + chart_height)});
  for (const double s : program.report.unwound_at)
    unwinds.push_back({Eigen::Vector2d(scale.x(s), scale.bottom), Eigen::Vector2d(scale.x(s), scale.bottom + chart_height)});
  if (!poles.empty())
    addBoxes(view, poles, pole_color);
  if (!unwinds.empty())
    addStrokes(view, unwinds, unwind_color, 1.5f);
}

} // namespace

void
writeRotaryAngles(const std::string& file, const std::string& title, const MachineProgram& program)
{
  const std::array<Curve, 3> curves = curvesOf(program);
  if (curves[0].at.empty() || !(curves[0].at.back() > 0.0))
    throw std::invalid_argument("a picture of rotary axes needs a program that cuts along a path");
  Sheet sheet;
  for (int i = 0; i < 3; ++i) {
    const Scale scale(curves[i], 2 - i, curves[0].at.back());
    addPlaces(sheet.view(), program, scale);
    addBoxes(sheet.view(), drawn(curves[i], scale), line_color);
    addAxes(sheet.view(), curves[i], scale, i == 2);
  }
  addCentredText(sheet.view(), "length of the path, mm", {0.5 * (left + right), 40.0}, name_size);
  const ProgramReport& report = program.report;
  std::string places;
  double largest_change = 0.0;
  for (const PoleZone& zone : report.poles)
    largest_change = std::max(largest_change, zone.largest_change);
  if (!report.poles.empty())
    places += "; yellow: axis blended at the pole";
  if (largest_change > no_change)
    places += formatted(", by up to %.3g degrees", largest_change * in_degrees);
  if (!report.unwound_at.empty())
    places += formatted("; red: unwinds, %.0f times", static_cast<double>(report.unwound_at.size()));
  if (program.machine.three_axes)
    sheet.addTitle(title + ": motion on " + program.machine.name, formatted("%.1f minutes at feed", report.minutes));
  else
    sheet.addTitle(title + ": rotary axes of " + program.machine.name,
                   formatted("%.1f turns in total, at most %.3g degrees in one block", report.first_travel * in_degrees / 360.0,
                             report.largest_turn * in_degrees) +
                       places);
  sheet.save(file);
}

} // namespace pcl_spiral
