// SPDX-License-Identifier: BSD-3-Clause
#include "motion_timer.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double overlap_share = 0.5; ///< of the acceleration, so that two moves together have all of it

bool
isTriangle(const MotionRun& run)
{
  return run.times.size() == 1 && run.times[0].seconds - run.times[0].rise - run.times[0].fall < 1e-9;
}

void
setEnds(const MotionRun& run, double start, std::vector<double>& ends)
{
  for (std::size_t i = 0; i < run.elements.size(); ++i) {
    const MotionElement& element = run.elements[i];
    const double end = start + run.times[i].seconds;
    if (element.first != element.second)
      ends[element.first] = 0.5 * (start + end);
    ends[element.second] = end;
    start = end;
  }
}

} // namespace

std::vector<double>
MotionTimer::ends(const std::vector<ControlMove>& moves) const
{
  std::vector<double> ends(moves.size(), 0.0);
  MotionRun before;
  double start = 0.0;
  for (std::size_t i = 0; i < moves.size();) {
    MotionRun run = takeRun(moves, before.after, i);
    run.times = elementTimes(run.elements, control_.look_ahead);
    for (const ElementTime& time : run.times)
      run.seconds += time.seconds;
    roundUp(run);
    start = before.times.empty() ? 0.0 : begin(before, start, run);
    setEnds(run, start, ends);
    before = std::move(run);
  }
  return ends;
}

/** When \p next begins after \p before, which began at \p begun. A move with an even part hands over in the cycle in which it begins to
 *  slow down. */
double
MotionTimer::begin(const MotionRun& before, double begun, const MotionRun& next) const
{
  if (before.after.rule != CornerRule::Overlap)
    return begun + before.seconds;
  const double fall = std::min(before.times.back().fall, before.after.speed / before.elements.back().acceleration);
  double way = before.seconds - std::min(fall, next.times.front().rise);
  if (control_.cycle > 0.0 && !isTriangle(before))
    way = control_.cycle * std::floor(way / control_.cycle + 1e-6);
  return begun + way;
}

/** A move that only speeds up and slows down ends with a cycle, and so does every stop. */
void
MotionTimer::roundUp(MotionRun& run) const
{
  const bool triangle = isTriangle(run);
  if (!(control_.cycle > 0.0) || !(triangle || run.after.rule == CornerRule::Stop))
    return;
  const double more = control_.cycle * std::ceil(run.seconds / control_.cycle - 1e-6) - run.seconds;
  ElementTime& last = run.times.back();
  if (triangle)
    last.rise += 0.5 * more;
  last.fall += triangle ? 0.5 * more : more;
  last.seconds += more;
  run.seconds += more;
}

/** The planner looks at each element at least once. */
void
MotionTimer::keepToCycles(MotionElement& element) const
{
  if (control_.least_cycles > 0.0)
    element.speed = std::min(element.speed, element.length / (control_.least_cycles * control_.cycle));
}

MoveCorner
MotionTimer::cornerAfter(const std::vector<ControlMove>& moves, std::size_t i) const
{
  MoveCorner corner;
  if (i + 1 < moves.size())
    corner = cornerBetween(moves[i], moves[i + 1], control_, axes_, tolerance_);
  else if (tolerance_ > 0.0 && control_.rotary_corner == CornerRule::Overlap)
    corner.rule = CornerRule::Overlap; // the last move waits for a next one
  return corner;
}

void
MotionTimer::addMove(const ControlMove& move, std::size_t i, const MoveCorner& before, const MoveCorner& after, double share,
                     MotionRun& run) const
{
  MotionElement line{move.length - before.cut - after.cut, move.speed, share * move.acceleration, move.jerk, after.speed, i, i};
  keepToCycles(line);
  const bool joins = after.arc > 0.0 && !run.elements.empty() && line.length < control_.gap_cycles * control_.cycle * after.speed;
  if (!joins)
    run.elements.push_back(line);
  if (!(after.arc > 0.0))
    return;
  run.elements.push_back({after.arc + (joins ? line.length : 0.0), after.speed, after.arc_acceleration, move.jerk, after.speed, i, i + 1});
  keepToCycles(run.elements.back());
}

/** The run that begins with move \p i behind the corner \p entry; \p i: that of the next run. */
MotionRun
MotionTimer::takeRun(const std::vector<ControlMove>& moves, const MoveCorner& entry, std::size_t& i) const
{
  MotionRun run;
  MoveCorner before = entry;
  for (bool ends = false; !ends; ++i) {
    const MoveCorner after = cornerAfter(moves, i);
    double share = 1.0 - std::max(before.lost_share, after.lost_share);
    if (before.rule == CornerRule::Overlap || after.rule == CornerRule::Overlap)
      share *= overlap_share;
    addMove(moves[i], i, before, after, share, run);
    ends = after.rule == CornerRule::Stop || after.rule == CornerRule::Overlap;
    before = after;
  }
  run.after = before;
  return run;
}

} // namespace pcl_spiral
