// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/scallop_loops.h>

#include "raw_loops.h"
#include "spiral/field/finger_axes.h"
#include "spiral/field/ridge_band.h"
#include "spiral/field/ridge_climb.h"
#include "spiral/field/step_over_march.h"
#include "spiral/lines/segment_set.h"
#include "tight_necks.h"

#include "common/stoppable_loop.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double neck_depth = 0.25;                     // how far D rises above a loop's level in a neck that is widened
constexpr double neck_agreement = 0.5;                  // gradients on its ridge agree at most this much
constexpr double ridge_agreement = 0.97;                // agreement of gradients about a node of any ridge: cos 14 degrees
constexpr double tight_neck = 0.25;                     // necks between nodes of the mesh that are narrower than this are widened
constexpr int most_redrawings = 3;                      // of one level: widened necks may meet other necks
constexpr double search_within = 1.2;                   // larger distances are not measured
constexpr double raised_below = 0.95;                   // levels from one to the nodes that its fingers change
constexpr std::size_t axis_stride = 8;                  // points of an axis between those about which nodes are looked for
constexpr double axis_part = 0.5;                       // step-overs: longer than so many points of it
constexpr std::size_t lower = NearestSegment::none - 1; // label
constexpr int levels_together = 64;                     // traced, then drawn
constexpr std::int64_t a_level = 1 << 11;               // what it takes, as a share of the work between two reports of the progress
constexpr double core_below = 0.38, core_above = 1.31;  // a core is examined between these levels

/** The loops of a level, and the axes of their fingers. */
struct DrawnLevel {
  std::vector<ScallopLoop> loops;
  std::vector<FingerAxis> axes;
};

/** Makes the loops of all levels. First they are traced as they lie on the field, then fingers are added to each level, from what its
 *  traced loops and those below leave uncovered; so levels do not depend on one another. Side by side are only levels so far apart that
 *  no node is in the way of two. */
class LoopMaker {
public:
  LoopMaker(const StepOverDistance& field, const RidgeBand& band, const RidgeClimb& climb, const ProgressCallback& progress,
            ScallopLoopSet& set)
  : field_(field), band_(band), climb_(climb), progress_(progress), set_(set), values_(field.distance), scratch_(field.mesh.size(), 0),
    agreement_(gradientAgreement(field.mesh, field.distance))
  {}

  bool run()
  {
    const int levels = static_cast<int>(std::floor(field_.largest)) + 1;
    sortTriangles(levels);
    addRims();
    const int apart = levelsApart();
    std::vector<std::vector<RawLoop>> traced(1); // from the level below the first on
    for (int first = 0; first < levels; first += levels_together) {
      const int count = std::min(levels - first, levels_together);
      const auto part = [&](double from, double to) {
        return partOf(progress_, (first + from * count) / levels, (first + to * count) / levels, "loops");
      };
      traced.resize(count + 1);
      const auto trace = [&](std::int64_t i) {
        const int level = first + static_cast<int>(i) + 1;
        traced[i + 1] = traceLoops(field_, band_, climb_, values_, level, triangles_[level]);
      };
      if (!stoppableLoop(0, count, part(0.0, 0.2), trace, a_level))
        return false;
      std::vector<DrawnLevel> drawn(count);
      for (int begin = 0; begin < std::min(apart, count); ++begin) {
        const auto draw = [&](std::int64_t i) {
          const auto k = begin + i * apart;
          drawn[k] = drawnLevel(first + static_cast<int>(k), traced[k], traced[k + 1]);
        };
        const double done = static_cast<double>(begin) / apart;
        if (!stoppableLoop(0, (count - begin + apart - 1) / apart, part(0.2 + 0.8 * done, 0.2 + 0.8 * (done + 1.0 / apart)), draw, a_level))
          return false;
      }
      for (DrawnLevel& level : drawn) {
        for (const FingerAxis& axis : level.axes)
          set_.axes.push_back(axis.points);
        std::move(level.loops.begin(), level.loops.end(), std::back_inserter(set_.loops));
      }
      traced.front() = std::move(traced.back());
    }
    return true;
  }

private:
  /** Data of the space between the loops of one level and the next. */
  struct Between {
    int level = 0;    ///< of the lower loops
    SegmentSet lines; ///< loops of both levels; the label of an upper one is its index, of the others lower
    std::unordered_set<std::uint32_t> thin_summits;
    std::vector<std::uint32_t> thin, done; ///< nodes that a finger reaches; nodes of finished cores; both ascending
  };

  /** The smallest and the largest of \p values at the corners of a triangle. */
  static std::pair<double, double> rangeOf(const std::vector<double>& values, const Triangulation::Triangle& c)
  {
    return std::minmax({values[c[0]], values[c[1]], values[c[2]]});
  }
  void sortTriangles(int levels);
  void addRims();
  int levelsApart() const;
  DrawnLevel drawnLevel(int k, const std::vector<RawLoop>& below, const std::vector<RawLoop>& above);
  std::vector<double> distancesOf(const std::vector<std::uint32_t>& nodes, const SegmentSet& lines, double enough) const;
  bool isThin(const Between& at, std::uint32_t v) const;
  void addLines(const std::vector<RawLoop>& below, const std::vector<RawLoop>& above, Between& at) const;
  void findCores(Between& at, std::vector<FingerAxis>& axes);
  void findFingersOf(const Between& at, std::vector<FingerAxis>& axes);
  std::vector<std::uint32_t> nodesAbout(int level, const std::vector<FingerAxis>& axes);
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
};

void
LoopMaker::sortTriangles(int levels)
{
  constexpr std::size_t parts = 64; // of the mesh
  const std::size_t count = field_.mesh.triangles.triangleCount();
  std::vector<std::vector<std::vector<std::uint32_t>>> found(parts);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t part = 0; part < parts; ++part) {
    found[part].resize(levels + 1);
    for (std::size_t i = count * part / parts; i < count * (part + 1) / parts; ++i) {
      const auto [low, high] = rangeOf(field_.distance, field_.mesh.triangles.triangle(i));
      for (int k = std::max(1, static_cast<int>(std::floor(low))); k <= levels && k <= high; ++k)
        found[part][k].push_back(static_cast<std::uint32_t>(i));
    }
  }
  triangles_.resize(levels + 1);
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = 0; k <= levels; ++k)
    for (const auto& part : found)
      triangles_[k].insert(triangles_[k].end(), part[k].begin(), part[k].end());
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
  }
}

std::vector<double>
LoopMaker::distancesOf(const std::vector<std::uint32_t>& nodes, const SegmentSet& lines, double enough) const
{
  std::vector<double> distances(nodes.size());
  constexpr std::size_t together = 256; // nodes that one thread takes at a time; the same for any number of threads
  const auto blocks = static_cast<std::int64_t>((nodes.size() + together - 1) / together);
#pragma omp parallel for schedule(dynamic) if (blocks > 8)
  for (std::int64_t block = 0; block < blocks; ++block) {
    std::size_t last = NearestSegment::none;
    for (std::size_t i = block * together; i < std::min(nodes.size(), (block + 1) * together); ++i) {
      const std::uint32_t v = nodes[i];
      const NearestSegment near = lines.nearestFrom(last, field_.mesh.positions[v], field_.mesh.metric[v], search_within, enough);
      distances[i] = near.distance;
      last = near.segment;
    }
  }
  return distances;
}

bool
LoopMaker::isThin(const Between& at, std::uint32_t v) const
{
  return field_.distance[v] >= at.level + 1.0 && at.thin_summits.count(climb_.summit(v)) > 0;
}

void
LoopMaker::addLines(const std::vector<RawLoop>& below, const std::vector<RawLoop>& above, Between& at) const
{
  for (std::size_t i = 0; at.level == 0 && i < field_.mesh.rims.size(); ++i)
    at.lines.add(set_.loops[i].points, true, lower);
  for (std::size_t i = 0; i < below.size(); ++i)
    if (!below[i].is_thin)
      addNearRuns(below[i].line, below[i].is_near, lower, at.lines);
  for (std::size_t i = 0; i < above.size(); ++i)
    if (!above[i].is_thin)
      addNearRuns(above[i].line, above[i].is_near, i, at.lines);
  at.lines.build();
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
  for (const std::vector<std::uint32_t>& group : connectedGroups(field_.mesh.triangles, core, scratch_)) {
    const std::vector<double> distances = distancesOf(group, at.lines, 0.0);
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
  std::vector<std::uint32_t> nodes;
  const std::vector<std::uint32_t> upper = band_.between(at.level + 0.5, at.level + 1.0);
  std::merge(upper.begin(), upper.end(), at.thin.begin(), at.thin.end(), std::back_inserter(nodes));
  std::set_difference(nodes.begin(), nodes.end(), at.done.begin(), at.done.end(), std::back_inserter(gap.nodes));
  gap.distances = distancesOf(gap.nodes, at.lines, covered_within);
  for (const std::uint32_t v : band_.between(at.level + 1.0, at.level + 1.0 + neck_depth))
    if (agreement_[v] < neck_agreement && !isThin(at, v))
      gap.necks.push_back(v);
  gap.is_ridge = [this](std::uint32_t v) { return agreement_[v] < ridge_agreement; };
  gap.is_above = [&](std::uint32_t v) { return field_.distance[v] >= at.level + 1.0 && !isThin(at, v); };
  gap.loop_near = [&](std::uint32_t v) {
    const NearestSegment near = at.lines.nearest(field_.mesh.positions[v], field_.mesh.metric[v], search_within, lower);
    return near.segment == NearestSegment::none ? near.segment : at.lines.label(near.segment);
  };
  findFingers(field_, climb_, gap, scratch_, axes);
}

/** Nodes of the band that fingers about \p axes may raise. */
std::vector<std::uint32_t>
LoopMaker::nodesAbout(int level, const std::vector<FingerAxis>& axes)
{
  std::vector<std::uint32_t> nodes;
  for (const FingerAxis& axis : axes)
    for (std::size_t i = 0; i < axis.points.size(); i += axis_stride)
      band_.forNodesNear(axis.points[i], (RaisedField::reach + axis_part) * longestStepOver(axis.metric[i]), [&](std::uint32_t v) {
        if (field_.distance[v] > level - raised_below && field_.distance[v] < level + RaisedField::mostRaised() && scratch_[v] == 0) {
          scratch_[v] = 1;
          nodes.push_back(v);
        }
      });
  for (const std::uint32_t v : nodes)
    scratch_[v] = 0;
  return nodes;
}

/** The loops of the field raised about \p axes; \p thin nodes are put below the level. */
std::vector<RawLoop>
LoopMaker::redrawn(int level, const std::vector<FingerAxis>& axes, const std::vector<std::uint32_t>& thin)
{
  const StepOverMesh& mesh = field_.mesh;
  const RaisedField raised(level, axes);
  std::vector<std::uint32_t> changed = nodesAbout(level, axes);
  for (const std::uint32_t v : thin)
    values_[v] = level - std::max(0.05, field_.distance[v] - level);
  std::size_t last = NearestSegment::none;
  for (const std::uint32_t v : changed)
    values_[v] = level + raised.at({mesh.positions[v], mesh.metric[v], values_[v]}, last);
  changed.insert(changed.end(), thin.begin(), thin.end());
  std::vector<std::uint32_t> crossed, triangles;
  for (const std::uint32_t v : changed)
    for (std::size_t o = mesh.triangles.outgoingBegin(v); o < mesh.triangles.outgoingBegin(v + 1); ++o)
      if (const auto [low, high] = rangeOf(values_, mesh.triangles.triangle(mesh.triangles.outgoing(o) / 3)); low < level && level <= high)
        crossed.push_back(mesh.triangles.outgoing(o) / 3);
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  std::set_union(triangles_[level].begin(), triangles_[level].end(), crossed.begin(), crossed.end(), std::back_inserter(triangles));
  std::vector<RawLoop> loops = traceLoops(field_, band_, climb_, values_, level, triangles, &raised);
  for (const std::uint32_t v : changed)
    values_[v] = field_.distance[v];
  return loops;
}

/** The loops above level \p k, those of \p above with fingers into the space between them and the loops of \p below. */
DrawnLevel
LoopMaker::drawnLevel(int k, const std::vector<RawLoop>& below, const std::vector<RawLoop>& above)
{
  DrawnLevel level;
  Between at;
  at.level = k;
  at.thin_summits = thinSummits(above);
  addLines(below, above, at);
  findCores(at, level.axes);
  findFingersOf(at, level.axes);
  std::vector<RawLoop> loops;
  for (const RawLoop& loop : above)
    if (!loop.is_thin)
      loops.push_back(loop);
  std::vector<FingerAxis> necks = tightNecks(loops, tight_neck);
  const bool redraw = !level.axes.empty() || !necks.empty();
  for (int round = 0; redraw; ++round) {
    level.axes.insert(level.axes.end(), necks.begin(), necks.end());
    loops = redrawn(k + 1, level.axes, at.thin);
    necks = tightNecks(loops, tight_neck);
    if (necks.empty() || round == most_redrawings)
      break;
  }
  for (const RawLoop& loop : loops)
    level.loops.push_back(finishedLoop(loop));
  return level;
}

/** How many levels on from one the next begins whose nodes it neither changes nor reads. A level changes nodes in a range of D of
 *  raised_below + mostRaised() about it, and reads those of the triangles about these. */
int
LoopMaker::levelsApart() const
{
  const Triangulation& t = field_.mesh.triangles;
  double widest = 0.0;
  const auto count = static_cast<std::int64_t>(t.triangleCount());
#pragma omp parallel for schedule(static, 4096) reduction(max : widest)
  for (std::int64_t i = 0; i < count; ++i) {
    const auto [low, high] = rangeOf(field_.distance, t.triangle(i));
    widest = std::max(widest, high - low);
  }
  return static_cast<int>(std::floor(raised_below + RaisedField::mostRaised() + widest)) + 1;
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
  if (!go_on() || !LoopMaker(field, band, climb, progress, set).run())
    return false;
  for (ScallopLoop& loop : set.loops)
    loop.basis = field.basis;
  return true;
}

} // namespace pcl_spiral
