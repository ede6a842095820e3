#include <pcl_spiral/toolpath/spiral_curve.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double closest_in_spacings = 0.4; // neighbouring lines on a turn
constexpr double widest_angle = 0.35;       // rad between neighbouring lines near the centre
constexpr double step_reserve = 0.98;       // projection stretches steps a little

struct HermiteSegment {
  Eigen::Vector3d a, b, ta, tb; ///< ends, and derivatives over chord length
  double chord;

  Eigen::Vector3d
  at(double t) const
  {
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * a + (3 * t2 - 2 * t3) * b + chord * ((t3 - 2 * t2 + t) * ta + (t3 - t2) * tb);
  }
};

/** A stretch of knots between corners. */
struct Stretch {
  std::size_t begin, end;
  double needed; ///< steps
};

/** The next count on a ladder whose rungs are five percent apart. */
double
wholeSteps(double needed)
{
  double rung = 1.0;
  while (rung < needed)
    rung = std::max(rung + 1.0, std::ceil(1.05 * rung));
  return rung;
}

/** Turns with the same number take as many steps: up to six percent of the turns below. */
int
turnGroup(double turn)
{
  constexpr double single = 16.0, growth = 1.06;
  const double whole = std::floor(std::max(0.0, turn));
  return static_cast<int>(whole < single ? whole : single + std::floor(std::log(whole / single) / std::log(growth)));
}

double
angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** How the curve winds from the inside out. An inward spiral is drawn so too and then run from its end, which turns its
 *  winding round. */
bool
drawnClockwise(const SpiralSettings& settings)
{
  return (settings.sense == SpiralSense::Clockwise) != (settings.direction == SpiralDirection::Inward);
}

} // namespace

SpiralCurve::SpiralCurve(const std::vector<RadialLine>& lines, const TurnFunction& turns,
                         const SpiralSettings& settings, double spacing)
: lines_(lines), turns_(turns), settings_(settings), spacing_(spacing),
  max_step_(settings.max_step > 0.0 ? settings.max_step : settings.tool_radius)
{
  findActiveShares();
}

void
SpiralCurve::setRim(Polyline rim, std::vector<std::size_t> corners)
{
  rim_ = {std::move(rim), std::move(corners), {}, true};
  meetLines(rim_);
}

void
SpiralCurve::setInner(Polyline inner, std::vector<std::size_t> corners)
{
  inner_ = {std::move(inner), std::move(corners), {}, false};
  meetLines(inner_);
}

void
SpiralCurve::meetLines(ClosedLoop& loop) const
{
  if (loop.at_rim) {
    for (const RadialLine& line : lines_)
      loop.line_shares.push_back(line.rim_share);
    loop.line_shares.push_back(1.0);
    return;
  }
  // Lines start on the inner loop in order: go round it once, to the place nearest to each line's start in turn.
  const std::size_t m = loop.points.size();
  const std::vector<double> s = arcLengths(loop.points, true);
  loop.line_shares.assign(1, 0.0);
  std::size_t from = 0;
  for (std::size_t i = 1; i < lines_.size(); ++i) {
    const Eigen::Vector3d start = lines_[i].feet.front().position;
    double best = std::numeric_limits<double>::max(), share = loop.line_shares.back();
    std::size_t found = from;
    for (std::size_t k = from; k < m && k < from + m / 2; ++k) {
      const Eigen::Vector3d d = loop.points[(k + 1) % m] - loop.points[k];
      const double f = std::clamp((start - loop.points[k]).dot(d) / d.squaredNorm(), 0.0, 1.0);
      const double distance = (loop.points[k] + f * d - start).norm();
      if (distance < best) {
        best = distance;
        found = k;
        share = (s[k] + f * (s[k + 1] - s[k])) / s[m];
      }
    }
    from = found;
    loop.line_shares.push_back(std::max(share, loop.line_shares.back()));
  }
  loop.line_shares.push_back(1.0);
}

void
SpiralCurve::findActiveShares()
{
  const std::size_t n = lines_.size();
  active_from_.assign(n, 0.0);
  int finest = 0;
  for (const RadialLine& line : lines_)
    finest = std::max(finest, line.level);
  const double closest = closest_in_spacings * spacing_;
  for (int level = 1; level <= finest; ++level)
    for (std::size_t i = 0; i < n; ++i) {
      if (lines_[i].level != level || lines_[i].corner)
        continue;
      // Its neighbours among the coarser lines, between which it stands.
      std::size_t left = (i + n - 1) % n, right = (i + 1) % n;
      while (lines_[left].level >= level)
        left = (left + n - 1) % n;
      while (lines_[right].level >= level)
        right = (right + 1) % n;
      const std::size_t last = lines_[i].feet.size() - 1;
      std::size_t k = 1;
      for (; k < last; ++k) { // the first station, from the centre, at which it is needed
        const auto at = [&](std::size_t line) {
          return lines_[line].feet[k * (lines_[line].feet.size() - 1) / last].position;
        };
        const double apart = (at(left) - at(i)).norm() + (at(right) - at(i)).norm();
        const double s = lines_[i].length() * static_cast<double>(k) / static_cast<double>(last);
        if (apart >= 2.0 * closest || apart >= widest_angle * s)
          break;
      }
      const double own = static_cast<double>(k - 1) / static_cast<double>(last);
      active_from_[i] = std::max({own, active_from_[left], active_from_[right]});
    }
}

std::vector<SpiralCurve::Knot>
SpiralCurve::turnKnots(std::size_t turn) const
{
  std::vector<Knot> knots;
  const std::size_t n = lines_.size();
  const bool clockwise = drawnClockwise(settings_);
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t i = clockwise ? (n - step) % n : step;
    const double delta = step == 0 ? 0.0 : clockwise ? 1.0 - lines_[i].turn_share : lines_[i].turn_share;
    const double tau = static_cast<double>(turn) + delta;
    const double s = turns_.arcLengthAt(i, tau);
    if (s < active_from_[i] * lines_[i].length())
      continue;
    knots.push_back({lines_[i].curve.positionAt(s), tau, turns_.feedStepAt(i, s), lines_[i].corner, step == 0});
  }
  return knots;
}

std::vector<SpiralCurve::Knot>
SpiralCurve::loopKnots(const ClosedLoop& loop, double turn) const
{
  const std::size_t m = loop.points.size(), n = lines_.size();
  const std::vector<double> s = arcLengths(loop.points, true);
  std::vector<std::uint8_t> corner(m, 0);
  for (const std::size_t c : loop.corners)
    corner[c] = 1;
  const bool clockwise = drawnClockwise(settings_);
  std::vector<Knot> knots;
  for (std::size_t step = 0; step <= m; ++step) {
    const std::size_t k = clockwise ? m - step : step; // m is the first point again, a whole lap on
    const double share = s[k] / s[m];
    const auto after = std::upper_bound(loop.line_shares.begin() + 1, loop.line_shares.end() - 1, share);
    const auto line = static_cast<std::size_t>(after - loop.line_shares.begin()) - 1;
    // Turns are counted by the lines' own shares, on loops too.
    const double next = line + 1 < n ? lines_[line + 1].turn_share : 1.0;
    const double width = loop.line_shares[line + 1] - loop.line_shares[line];
    const double f = width > 0.0 ? (share - loop.line_shares[line]) / width : 0.0;
    const double delta = lines_[line].turn_share + f * (next - lines_[line].turn_share);
    knots.push_back({loop.points[k % m], turn + (clockwise ? 1.0 - delta : delta),
                     turns_.feedStepAt(line, loop.at_rim ? lines_[line].length() : 0.0),
                     corner[k % m] != 0 || step == 0 || step == m, false});
  }
  return knots;
}

std::vector<SpiralCurve::Knot>
SpiralCurve::turnBesideLoop(const ClosedLoop& loop, std::size_t turn) const
{
  // Where each line, and line 0 again at the turn's end, stands off the loop.
  struct Offset {
    double gone; ///< share of the turn
    Eigen::Vector3d by;
  };
  const std::size_t n = lines_.size();
  const bool clockwise = drawnClockwise(settings_);
  std::vector<Offset> offsets;
  for (std::size_t step = 0; step <= n; ++step) {
    const std::size_t i = (clockwise ? n - step : step) % n;
    const double share = lines_[i].turn_share;
    const double gone = step == 0 ? 0.0 : step == n ? 1.0 : clockwise ? 1.0 - share : share;
    const double along = turns_.arcLengthAt(i, static_cast<double>(turn) + gone);
    offsets.push_back({gone, lines_[i].curve.positionAt(along) -
                                 lines_[i].curve.positionAt(loop.at_rim ? lines_[i].length() : 0.0)});
  }
  std::vector<Knot> knots = loopKnots(loop, static_cast<double>(turn));
  std::size_t j = 0;
  for (Knot& knot : knots) {
    const double gone = knot.turn - static_cast<double>(turn);
    while (j + 2 < offsets.size() && offsets[j + 1].gone <= gone)
      ++j;
    const double f = std::clamp((gone - offsets[j].gone) / (offsets[j + 1].gone - offsets[j].gone), 0.0, 1.0);
    knot.position += (1.0 - f) * offsets[j].by + f * offsets[j + 1].by;
  }
  return knots;
}

std::vector<SpiralCurve::Knot>
SpiralCurve::knots() const
{
  const auto count = static_cast<std::int64_t>(turns_.turns());
  const bool two = !inner_.points.empty();
  std::vector<std::vector<Knot>> parts(count + 2);
  if (two)
    parts.front() = loopKnots(inner_, -1.0);
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t j = 0; j < count; ++j)
    parts[j + 1] = turnKnots(j);
  // The turns next to a loop follow it, so that they cannot cross it however close they come.
  if (two)
    parts[1] = turnBesideLoop(inner_, 0);
  if (count > 1)
    parts[count] = turnBesideLoop(rim_, count - 1);
  parts.back() = loopKnots(rim_, static_cast<double>(count));
  std::vector<Knot> all;
  for (auto& part : parts) {
    for (const Knot& knot : part) {
      // The end of one part is the start of the next; near the centre lines coincide.
      if (!all.empty() && (knot.position - all.back().position).norm() < 1e-6 * spacing_) {
        all.back().corner = all.back().corner || knot.corner;
        all.back().anchor = all.back().anchor || knot.anchor;
        continue;
      }
      all.push_back(knot);
      all.back().turn += two ? 1.0 : 0.0;
    }
    std::vector<Knot>().swap(part);
  }
  return all;
}

std::vector<Eigen::Vector3d>
SpiralCurve::tangents(const std::vector<Knot>& knots, bool after_corner) const
{
  const auto n = static_cast<std::int64_t>(knots.size());
  std::vector<Eigen::Vector3d> result(n);
  // Parabolas over chord length: through both neighbours, or through the two on the side asked for at a corner.
  const auto oneSided = [&](std::int64_t p, std::int64_t direction) -> Eigen::Vector3d {
    const std::int64_t q = p + direction, r = p + 2 * direction;
    const Eigen::Vector3d first = knots[q].position - knots[p].position;
    const double h1 = first.norm();
    Eigen::Vector3d slope = first / h1;
    if (r >= 0 && r < n && !knots[q].corner) {
      const Eigen::Vector3d second = knots[r].position - knots[q].position;
      const double h2 = second.norm();
      slope += (slope - second / h2) * (h1 / (h1 + h2));
    }
    return static_cast<double>(direction) * slope;
  };
#pragma omp parallel for schedule(static)
  for (std::int64_t k = 0; k < n; ++k) {
    const bool first = k == 0, last = k + 1 == n;
    if (first || last || knots[k].corner) {
      const bool ahead = first || (!last && after_corner);
      result[k] = oneSided(k, ahead ? 1 : -1);
      continue;
    }
    const Eigen::Vector3d back = knots[k].position - knots[k - 1].position;
    const Eigen::Vector3d ahead = knots[k + 1].position - knots[k].position;
    const double h0 = back.norm(), h1 = ahead.norm();
    result[k] = (back * (h1 / h0) + ahead * (h0 / h1)) / (h0 + h1);
  }
  return result;
}

std::vector<SpiralPoint>
SpiralCurve::sample() const
{
  const std::vector<Knot> knots = this->knots();
  const std::vector<Eigen::Vector3d> leaving = tangents(knots, true), arriving = tangents(knots, false);
  const std::size_t segments = knots.size() - 1;
  // Steps each segment needs, then equal shares of them between corners.
  std::vector<double> steps(segments);
  for (std::size_t k = 0; k < segments; ++k) {
    const double chord = (knots[k + 1].position - knots[k].position).norm();
    const double turned = angleBetween(leaving[k], arriving[k + 1]);
    const double length = chord * (1.0 + turned * turned / 24.0);
    const double bend = turned > 0.0 ? 2.0 * std::sqrt(2.0 * settings_.chord_error * length / turned) : max_step_;
    const double step = std::min({knots[k].step, knots[k + 1].step, bend, max_step_});
    steps[k] = length / (step_reserve * step);
  }
  std::vector<Stretch> stretches;
  for (std::size_t begin = 0; begin < segments;) {
    Stretch stretch{begin, begin + 1, steps[begin]};
    while (stretch.end < segments && !knots[stretch.end].corner && !knots[stretch.end].anchor)
      stretch.needed += steps[stretch.end++];
    stretches.push_back(stretch);
    begin = stretch.end;
  }
  // Counts that few decisions settle, and rungs, hardly ever change with rounding in the input: alike stretches of
  // neighbouring turns take the same.
  std::map<std::pair<int, int>, double> counts;
  std::vector<std::pair<int, int>> alike; // group of turns, place in the turn
  double last_turn = -1.0;
  for (const Stretch& stretch : stretches) {
    const int group = turnGroup(knots[stretch.begin].turn);
    const bool same_turn = !alike.empty() && std::floor(knots[stretch.begin].turn) == last_turn;
    alike.emplace_back(group, same_turn ? alike.back().second + 1 : 0);
    last_turn = std::floor(knots[stretch.begin].turn);
    double& count = counts[alike.back()];
    count = std::max(count, wholeSteps(stretch.needed));
  }
  std::vector<SpiralPoint> points;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto [begin, end, needed] = stretches[i];
    const double each = needed / counts[alike[i]];
    double before = 0.0, next = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      const HermiteSegment segment{knots[k].position, knots[k + 1].position, leaving[k], arriving[k + 1],
                                   (knots[k + 1].position - knots[k].position).norm()};
      for (; next < before + steps[k] && next < needed - 0.5 * each; next += each) {
        const double t = (next - before) / steps[k];
        points.push_back({segment.at(t), knots[k].turn + t * (knots[k + 1].turn - knots[k].turn)});
      }
      before += steps[k];
    }
  }
  points.push_back({knots.back().position, knots.back().turn});
  if (settings_.direction == SpiralDirection::Inward) {
    const double all_turns = points.back().turn;
    std::reverse(points.begin(), points.end());
    for (SpiralPoint& p : points)
      p.turn = all_turns - p.turn;
  }
  return points;
}

} // namespace pcl_spiral
