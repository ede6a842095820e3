// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/scallop_loops.h>

#include "raw_loops.h"
#include "spiral/field/finger_axes.h"
#include "spiral/field/ridge_band.h"
#include "spiral/field/ridge_climb.h"
#include "spiral/field/step_over_march.h"
#include "spiral/lines/segment_set.h"
#include "tight_necks.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double blend = 0.25;                         // of smax
constexpr double neck_depth = 0.25;                    // how far D rises above a loop's level in a neck that is widened
constexpr double neck_agreement = 0.5;                 // gradients on its ridge agree at most this much
constexpr double ridge_agreement = 0.97;               // agreement of gradients about a node of any ridge: cos 14 degrees
constexpr double tight_neck = 0.25;                    // necks between nodes of the mesh that are narrower than this are widened
constexpr int most_redrawings = 3;                     // of one level: widened necks may meet other necks
constexpr double axis_reach = 1.2;                     // a finger changes the field up to this distance from its axis
constexpr double search_within = 1.2;                  // larger distances are not measured
constexpr int levels_together = 64;                    // drawn side by side
constexpr double core_below = 0.38, core_above = 1.31; // a core is examined between these levels

/** max(a, b) with a rounded corner. */
double
smoothMax(double a, double b)
{
  const double d = std::max(blend - std::abs(a - b), 0.0);
  return std::max(a, b) + d * d / (4.0 * blend);
}

/** The loops one level above another without fingers; parallel arrays. */
struct DrawnLevel {
  std::vector<RawLoop> raw;
  std::vector<FinishedLoop> finished;
};

/** Makes loops level by level; fingers are added to a level before the next is drawn. */
class LoopMaker {
public:
  LoopMaker(const StepOverDistance& field, const RidgeBand& band, const RidgeClimb& climb, const ProgressCallback& progress,
            ScallopLoopSet& set)
  : field_(field), band_(band), climb_(climb), progress_(progress), set_(set), values_(field.distance), scratch_(field.mesh.size(), 0),
    agreement_(gradientAgreement(field.mesh, field.distance))
  {}

  bool run()
  {
    const int levels = static_cast<int>(std::floor(field_.largest));
    sortTriangles(levels + 1);
    addRims();
    for (int first = 0; first <= levels; first += levels_together) {
      std::vector<DrawnLevel> drawn = draw(first, std::min(levels + 1, first + levels_together));
      for (int k = first; k < first + static_cast<int>(drawn.size()); ++k) {
        if (progress_ && !progress_(static_cast<double>(k) / (levels + 1), "loops"))
          return false;
        addLevel(k, std::move(drawn[k - first]));
      }
    }
    return true;
  }

private:
  /** Data of the space between the loops of one level and the next. */
  struct Between {
    int level = 0;           ///< of the lower loops
    SegmentSet lines, upper; ///< loops of both levels; loops of the upper level
    std::unordered_set<std::uint32_t> thin_summits;
    std::vector<std::uint32_t> thin, done; ///< nodes that a finger reaches; nodes of finished cores, ascending
  };

  void sortTriangles(int levels);
  void addRims();
  std::vector<DrawnLevel> draw(int first, int end) const;
  void addLevel(int k, DrawnLevel level);
  std::vector<double> distancesOf(const std::vector<std::uint32_t>& nodes, const SegmentSet& lines) const;
  bool isThin(const Between& at, std::uint32_t v) const;
  void addLines(const std::vector<RawLoop>& base, Between& at) const;
  void findCores(Between& at, std::vector<FingerAxis>& axes);
  void findFingersOf(const Between& at, std::vector<FingerAxis>& axes);
  void raise(int level, const std::vector<FingerAxis>& axes, const std::vector<std::uint32_t>& thin, std::vector<std::uint32_t>& changed);
  std::vector<RawLoop> redrawn(int level, const std::vector<FingerAxis>& axes, const std::vector<std::uint32_t>& thin);

  const StepOverDistance& field_;
  const RidgeBand& band_;
  const RidgeClimb& climb_;
  const ProgressCallback& progress_;
  ScallopLoopSet& set_;
  std::vector<double> values_;                        ///< D, changed about fingers while their level is drawn
  std::vector<std::vector<std::uint32_t>> triangles_; ///< crossed by each level
  std::vector<std::uint32_t> scratch_;                ///< one a node, 0 between uses
  std::vector<float> agreement_;                      ///< of the gradients about each node: small on ridges between facing sides
  std::vector<FinishedLoop> below_;                   ///< loops of the level before
};

void
LoopMaker::sortTriangles(int levels)
{
  triangles_.resize(levels + 1);
  const Triangulation& t = field_.mesh.triangles;
  for (std::uint32_t i = 0; i < t.triangleCount(); ++i) {
    const auto& c = t.triangle(i);
    const double low = std::min({field_.distance[c[0]], field_.distance[c[1]], field_.distance[c[2]]});
    const double high = std::max({field_.distance[c[0]], field_.distance[c[1]], field_.distance[c[2]]});
    for (int k = std::max(1, static_cast<int>(std::floor(low))); k <= levels && k <= high; ++k)
      triangles_[k].push_back(i);
  }
}

void
LoopMaker::addRims()
{
  for (const std::vector<std::uint32_t>& rim : field_.mesh.rims) {
    ScallopLoop loop;
    for (const std::uint32_t v : rim) {
      loop.points.push_back(field_.mesh.positions[v]);
      loop.metric.push_back(field_.mesh.metric[v]);
    }
    loop.measure();
    set_.loops.push_back(loop);
    below_.push_back({loop, std::vector<std::uint8_t>(loop.points.size(), 1)});
  }
}

std::vector<double>
LoopMaker::distancesOf(const std::vector<std::uint32_t>& nodes, const SegmentSet& lines) const
{
  std::vector<double> distances(nodes.size());
  const auto count = static_cast<std::int64_t>(nodes.size());
#pragma omp parallel for schedule(dynamic, 256) if (count > 2048)
  for (std::int64_t i = 0; i < count; ++i)
    distances[i] = lines.nearest(field_.mesh.positions[nodes[i]], field_.mesh.metric[nodes[i]], search_within).distance;
  return distances;
}

bool
LoopMaker::isThin(const Between& at, std::uint32_t v) const
{
  return field_.distance[v] >= at.level + 1.0 && at.thin_summits.count(climb_.summit(v)) > 0;
}

void
LoopMaker::addLines(const std::vector<RawLoop>& base, Between& at) const
{
  for (std::size_t i = 0; i < below_.size(); ++i)
    addNearRuns(below_[i].line, below_[i].is_near, i, at.lines);
  for (std::size_t i = 0; i < base.size(); ++i)
    if (!base[i].is_thin) {
      addNearRuns(base[i].line, base[i].is_near, i, at.lines);
      addNearRuns(base[i].line, base[i].is_near, i, at.upper);
    }
  at.lines.build();
  at.upper.build();
}

/** Axes about summits that no loop of the next level goes round. */
void
LoopMaker::findCores(Between& at, std::vector<FingerAxis>& axes)
{
  std::vector<std::uint32_t> core;
  for (const std::uint32_t v : band_.between(at.level + core_below, at.level + core_above)) {
    if (field_.distance[climb_.summit(v)] < at.level + 1.0 || at.thin_summits.count(climb_.summit(v)) > 0)
      core.push_back(v);
    if (isThin(at, v))
      at.thin.push_back(v);
  }
  std::sort(core.begin(), core.end());
  for (const std::vector<std::uint32_t>& group : connectedGroups(field_.mesh.triangles, core, scratch_)) {
    const std::vector<double> distances = distancesOf(group, at.lines);
    if (*std::max_element(distances.begin(), distances.end()) <= covered_within + 0.004)
      continue;
    findCoreAxes(field_, group, distances, scratch_, axes);
    at.done.insert(at.done.end(), group.begin(), group.end());
  }
  std::sort(at.done.begin(), at.done.end());
}

/** Axes in places that the lower and the next loops leave uncovered, and in necks of the next loops. */
void
LoopMaker::findFingersOf(const Between& at, std::vector<FingerAxis>& axes)
{
  LevelGap gap;
  gap.level = at.level;
  const auto addOpen = [&](const std::vector<std::uint32_t>& nodes) {
    for (const std::uint32_t v : nodes)
      if (!std::binary_search(at.done.begin(), at.done.end(), v))
        gap.nodes.push_back(v);
  };
  addOpen(band_.between(at.level + 0.5, at.level + 1.0));
  addOpen(at.thin);
  std::sort(gap.nodes.begin(), gap.nodes.end());
  gap.distances = distancesOf(gap.nodes, at.lines);
  for (const std::uint32_t v : band_.between(at.level + 1.0, at.level + 1.0 + neck_depth))
    if (agreement_[v] < neck_agreement && !isThin(at, v))
      gap.necks.push_back(v);
  std::sort(gap.necks.begin(), gap.necks.end());
  gap.is_ridge = [this](std::uint32_t v) { return agreement_[v] < ridge_agreement; };
  gap.is_above = [&](std::uint32_t v) { return field_.distance[v] >= at.level + 1.0 && !isThin(at, v); };
  gap.loop_near = [&](std::uint32_t v) {
    const NearestSegment near = at.upper.nearest(field_.mesh.positions[v], field_.mesh.metric[v], search_within);
    return near.segment == NearestSegment::none ? near.segment : at.upper.label(near.segment);
  };
  findFingers(field_, climb_, gap, scratch_, axes);
}

/** F := smax(D, level + finger_radius - distance from the axes) about \p axes; \p thin nodes are put below the level. */
void
LoopMaker::raise(int level, const std::vector<FingerAxis>& axes, const std::vector<std::uint32_t>& thin,
                 std::vector<std::uint32_t>& changed)
{
  SegmentSet lines;
  for (const FingerAxis& axis : axes) {
    lines.add(axis.points, false);
    for (std::size_t i = 0; i < axis.points.size(); ++i)
      band_.forNodesNear(axis.points[i], axis_reach * longestStepOver(axis.metric[i]), [&](std::uint32_t v) {
        if (scratch_[v] == 0 && field_.distance[v] > level - 0.95 && field_.distance[v] < level + 1.5) {
          scratch_[v] = 1;
          changed.push_back(v);
        }
      });
  }
  lines.build();
  for (const std::uint32_t v : changed)
    scratch_[v] = 0;
  for (const std::uint32_t v : thin)
    values_[v] = level - std::max(0.05, field_.distance[v] - level);
  for (const std::uint32_t v : changed) {
    const double d = lines.nearest(field_.mesh.positions[v], field_.mesh.metric[v], axis_reach).distance;
    if (d < axis_reach)
      values_[v] = level + smoothMax(std::clamp(values_[v] - level, -3.0, 3.0), finger_radius - d);
  }
  changed.insert(changed.end(), thin.begin(), thin.end());
}

std::vector<RawLoop>
LoopMaker::redrawn(int level, const std::vector<FingerAxis>& axes, const std::vector<std::uint32_t>& thin)
{
  std::vector<std::uint32_t> changed;
  raise(level, axes, thin, changed);
  std::vector<std::uint32_t> triangles = triangles_[level];
  for (const std::uint32_t v : changed)
    for (std::size_t o = field_.mesh.triangles.outgoingBegin(v); o < field_.mesh.triangles.outgoingBegin(v + 1); ++o)
      triangles.push_back(field_.mesh.triangles.outgoing(o) / 3);
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::vector<RawLoop> loops = traceLoops(field_, band_, climb_, values_, level, triangles);
  for (const std::uint32_t v : changed)
    values_[v] = field_.distance[v];
  return loops;
}

/** The loops above levels \p first to \p end: most have no fingers, so they are drawn in parallel. */
std::vector<DrawnLevel>
LoopMaker::draw(int first, int end) const
{
  std::vector<DrawnLevel> drawn(end - first);
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = first; k < end; ++k) {
    DrawnLevel& level = drawn[k - first];
    level.raw = traceLoops(field_, band_, climb_, values_, k + 1, triangles_[k + 1]);
    for (const RawLoop& loop : level.raw)
      level.finished.push_back(loop.is_thin ? FinishedLoop() : finishedLoop(field_, loop));
  }
  return drawn;
}

void
LoopMaker::addLevel(int k, DrawnLevel level)
{
  std::vector<RawLoop>& loops = level.raw;
  Between at;
  at.level = k;
  at.thin_summits = thinSummits(loops);
  addLines(loops, at);
  std::vector<FingerAxis> axes;
  findCores(at, axes);
  findFingersOf(at, axes);
  loops.erase(std::remove_if(loops.begin(), loops.end(), [](const RawLoop& l) { return l.is_thin; }), loops.end());
  std::vector<FinishedLoop>& finished = level.finished;
  finished.erase(std::remove_if(finished.begin(), finished.end(), [](const FinishedLoop& l) { return l.line.points.empty(); }),
                 finished.end());
  std::vector<FingerAxis> necks = tightNecks(loops, tight_neck);
  const bool redraw = !axes.empty() || !necks.empty();
  for (int round = 0; redraw; ++round) {
    axes.insert(axes.end(), necks.begin(), necks.end());
    loops = redrawn(k + 1, axes, at.thin);
    necks = tightNecks(loops, tight_neck);
    if (necks.empty() || round == most_redrawings)
      break;
  }
  for (const FingerAxis& axis : axes)
    set_.axes.push_back(axis.points);
  if (redraw) {
    finished.clear();
    for (const RawLoop& loop : loops)
      finished.push_back(finishedLoop(field_, loop));
  }
  below_ = std::move(finished);
  for (const FinishedLoop& loop : below_)
    set_.loops.push_back(loop.line);
}

} // namespace

bool
makeScallopLoops(const StepOverDistance& field, const ProgressCallback& progress, ScallopLoopSet& set)
{
  set = ScallopLoopSet();
  const auto go_on = [&progress] { return !progress || progress(0.0, "loops"); };
  if (!go_on())
    return false;
  const RidgeBand band(field);
  if (!go_on())
    return false;
  const RidgeClimb climb(field);
  return go_on() && LoopMaker(field, band, climb, progress, set).run();
}

} // namespace pcl_spiral
