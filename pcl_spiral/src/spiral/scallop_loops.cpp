#include <pcl_spiral/spiral/scallop_loops.h>

#include "finger_axes.h"
#include "line_smoothing.h"
#include "ridge_climb.h"
#include "segment_set.h"
#include "step_over_march.h"

#include <pcl_spiral/search/level_lines.h>
#include <pcl_spiral/search/point_blocks.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double fine_step = 0.08;   // of a loop's points in the band, step-overs
constexpr double fine_width = 0.3;   // half the length its jaggedness is smoothed over there
constexpr double coarse_step = 0.4;  // shares of an edge of the mesh elsewhere
constexpr double coarse_width = 1.2;
constexpr double shortest_loop = 0.5; // step-overs
constexpr double blend = 0.25;        // of smax
constexpr double neck_depth = 0.25;   // how far D rises above a loop's level in a neck that is widened
constexpr double neck_agreement = 0.5; // gradients on its ridge agree no more than this
constexpr double axis_reach = 1.2;    // a finger changes the field so far from its axis
constexpr double near_band = 1.5;     // loops as near as this to the band are searched, step-overs
constexpr double search_within = 1.2; // distances are not told beyond

/** max(a, b) with a rounded corner. */
double
smoothMax(double a, double b)
{
  const double d = std::max(blend - std::abs(a - b), 0.0);
  return std::max(a, b) + d * d / (4.0 * blend);
}

/** A loop as it was drawn on the mesh. */
struct RawLoop {
  ScallopLoop line;
  std::vector<std::uint8_t> is_fine; ///< one a point
  std::vector<std::uint8_t> is_near; ///< one a point: so near to the band that its nodes may be nearest to it
  std::vector<float> edges;          ///< length of the edge each point lies on, step-overs
  std::vector<std::uint32_t> summits; ///< that the nodes within it lead to
  bool is_thin = false;              ///< goes round summits that a finger reaches
};

class LoopMaker {
public:
  LoopMaker(const StepOverDistance& field, const ProgressCallback& progress, ScallopLoopSet& set)
      : field_(field), progress_(progress), set_(set), climb_(field), values_(field.distance), scratch_(field.mesh.size(), 0),
        agreement_(gradientAgreement(field.mesh, field.distance))
  {
  }

  bool
  run()
  {
    sortBand();
    const int levels = static_cast<int>(std::floor(field_.largest));
    sortTriangles(levels + 1);
    addRims();
    for (int k = 0; k <= levels; ++k) {
      if (progress_ && !progress_(static_cast<double>(k) / (levels + 1), "loops"))
        return false;
      addLevel(k);
    }
    return true;
  }

private:
  void sortBand();
  void sortTriangles(int levels);
  void addRims();
  void addLevel(int k);
  std::vector<RawLoop> trace(int level, const std::vector<std::uint32_t>& triangles) const;
  RawLoop raw(const LevelLine& line, int level) const;
  ScallopLoop finished(const RawLoop& loop, std::vector<std::uint8_t>& is_near) const;
  std::vector<std::uint32_t> bandBetween(double low, double high) const;
  void addNearRuns(const ScallopLoop& loop, const std::vector<std::uint8_t>& is_near, std::size_t label, SegmentSet& set) const;
  std::vector<double> distancesOf(const std::vector<std::uint32_t>& nodes, const SegmentSet& lines) const;
  std::vector<FingerAxis> findAxes(int k, const std::vector<RawLoop>& base, std::vector<std::uint32_t>& thin);
  void raise(int level, const std::vector<FingerAxis>& axes, const std::vector<std::uint32_t>& thin, std::vector<std::uint32_t>& changed);

  const StepOverDistance& field_;
  const ProgressCallback& progress_;
  ScallopLoopSet& set_;
  RidgeClimb climb_;
  std::vector<double> values_;                ///< D, changed about fingers while their level is drawn
  std::vector<std::uint32_t> band_;           ///< fine nodes by rising D
  std::vector<std::uint8_t> is_near_;         ///< one a node: within 1.5 step-overs of the band
  std::vector<std::uint32_t> about_;          ///< nodes of triangles with a fine node, in the order of blocks_
  PointBlocks blocks_;
  std::vector<std::vector<std::uint32_t>> triangles_; ///< crossed by each level
  std::vector<std::uint32_t> scratch_;
  std::vector<float> agreement_;              ///< of the gradients about each node: small on ridges between sides that face
  std::vector<ScallopLoop> below_;            ///< loops of the level before
  std::vector<std::vector<std::uint8_t>> below_near_;
};

void
LoopMaker::sortBand()
{
  std::vector<std::uint8_t> is_about(field_.mesh.size(), 0);
  const Triangulation& t = field_.mesh.triangles;
  for (std::size_t i = 0; i < t.triangleCount(); ++i) {
    const auto& c = t.triangle(i);
    if (field_.is_fine[c[0]] || field_.is_fine[c[1]] || field_.is_fine[c[2]])
      for (const std::uint32_t v : c)
        is_about[v] = 1;
  }
  is_near_ = field_.is_fine;
  for (int ring = 0; ring < static_cast<int>(std::ceil(near_band / field_.usual_edge)); ++ring) {
    const std::vector<std::uint8_t> before = is_near_;
    for (std::size_t i = 0; i < t.triangleCount(); ++i) {
      const auto& c = t.triangle(i);
      if (before[c[0]] || before[c[1]] || before[c[2]])
        for (const std::uint32_t v : c)
          is_near_[v] = 1;
    }
  }
  std::vector<Eigen::Vector3f> points;
  for (std::uint32_t v = 0; v < field_.mesh.size(); ++v) {
    if (field_.is_fine[v])
      band_.push_back(v);
    if (is_about[v]) {
      about_.push_back(v);
      points.push_back(field_.mesh.positions[v].cast<float>());
    }
  }
  std::sort(band_.begin(), band_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return std::make_pair(field_.distance[a], a) < std::make_pair(field_.distance[b], b);
  });
  if (!points.empty())
    blocks_ = PointBlocks(std::move(points));
}

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
    below_near_.emplace_back(loop.points.size(), 1);
    below_.push_back(std::move(loop));
  }
}

RawLoop
LoopMaker::raw(const LevelLine& line, int level) const
{
  RawLoop loop;
  loop.line.level = level;
  loop.is_thin = true;
  for (const LevelCrossing& c : line.crossings) {
    const double share = std::clamp(c.share, 1e-6, 1.0 - 1e-6);
    loop.line.points.push_back((1.0 - share) * field_.mesh.positions[c.below] + share * field_.mesh.positions[c.above]);
    loop.line.metric.push_back(between(field_.mesh.metric[c.below], field_.mesh.metric[c.above], share));
    loop.is_fine.push_back(field_.is_fine[c.below] && field_.is_fine[c.above]);
    loop.is_near.push_back(is_near_[c.below] || is_near_[c.above]);
    loop.edges.push_back(static_cast<float>(edgeLength(field_.mesh, c.below, c.above)));
    const std::uint32_t summit = climb_.summit(c.above);
    loop.is_thin = loop.is_thin && field_.distance[summit] < level + finger_radius;
    if (loop.summits.empty() || loop.summits.back() != summit)
      loop.summits.push_back(summit);
  }
  loop.line.measure();
  return loop;
}

std::vector<RawLoop>
LoopMaker::trace(int level, const std::vector<std::uint32_t>& triangles) const
{
  std::vector<RawLoop> loops;
  for (const LevelLine& line : levelLines(field_.mesh.triangles, values_, level, triangles)) {
    if (!line.closed || line.crossings.size() < 3)
      continue;
    RawLoop loop = raw(line, level);
    if (loop.line.length() > shortest_loop)
      loops.push_back(std::move(loop));
  }
  return loops;
}

ScallopLoop
LoopMaker::finished(const RawLoop& loop, std::vector<std::uint8_t>& is_near) const
{
  LineGrain grain;
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    grain.steps.push_back(loop.is_fine[i] ? fine_step : std::max(fine_step, coarse_step * field_.usual_edge));
    grain.widths.push_back(loop.is_fine[i] ? fine_width : std::max(fine_width, coarse_width * field_.usual_edge));
  }
  std::vector<std::size_t> from;
  ScallopLoop line = smoothed(loop.line, grain, from);
  is_near.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    is_near[i] = loop.is_near[from[i]];
  return line;
}

std::vector<std::uint32_t>
LoopMaker::bandBetween(double low, double high) const
{
  const auto less = [this](std::uint32_t v, double d) { return field_.distance[v] < d; };
  const auto begin = std::lower_bound(band_.begin(), band_.end(), low, less);
  return {begin, std::lower_bound(begin, band_.end(), high, less)};
}

void
LoopMaker::addNearRuns(const ScallopLoop& loop, const std::vector<std::uint8_t>& is_near, std::size_t label, SegmentSet& set) const
{
  const std::size_t n = loop.points.size();
  std::vector<std::uint8_t> wanted(n, 0);
  bool all = true;
  for (std::size_t i = 0; i < n; ++i) {
    wanted[i] = is_near[i] || is_near[(i + 1) % n] || is_near[(i + n - 1) % n];
    all = all && wanted[i];
  }
  if (all) {
    set.add(loop.points, true, label);
    return;
  }
  std::size_t first = 0;
  while (first < n && wanted[first])
    ++first;
  Polyline run;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    if (wanted[i])
      run.push_back(loop.points[i]);
    else if (!run.empty()) {
      set.add(run, false, label);
      run.clear();
    }
  }
}

std::vector<double>
LoopMaker::distancesOf(const std::vector<std::uint32_t>& nodes, const SegmentSet& lines) const
{
  std::vector<double> distances(nodes.size());
  const auto count = static_cast<std::int64_t>(nodes.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < count; ++i)
    distances[i] = lines.nearest(field_.mesh.positions[nodes[i]], field_.mesh.metric[nodes[i]], search_within).distance;
  return distances;
}

std::vector<FingerAxis>
LoopMaker::findAxes(int k, const std::vector<RawLoop>& base, std::vector<std::uint32_t>& thin)
{
  SegmentSet lines, upper;
  for (std::size_t i = 0; i < below_.size(); ++i)
    addNearRuns(below_[i], below_near_[i], i, lines);
  for (std::size_t i = 0; i < base.size(); ++i)
    if (!base[i].is_thin) {
      addNearRuns(base[i].line, base[i].is_near, i, lines);
      addNearRuns(base[i].line, base[i].is_near, i, upper);
    }
  lines.build();
  upper.build();
  std::unordered_set<std::uint32_t> thin_summits;
  for (const bool is_thin : {true, false})
    for (const RawLoop& loop : base)
      for (const std::uint32_t s : loop.summits)
        if (loop.is_thin == is_thin)
          is_thin ? (void)thin_summits.insert(s) : (void)thin_summits.erase(s);
  const auto isThin = [&](std::uint32_t v) { return field_.distance[v] >= k + 1.0 && thin_summits.count(climb_.summit(v)) > 0; };
  const auto isCore = [&](std::uint32_t v) {
    return field_.distance[climb_.summit(v)] < k + 1.0 || thin_summits.count(climb_.summit(v)) > 0;
  };
  std::vector<FingerAxis> axes;
  // Cores: about summits that no loop of the next level goes round.
  std::vector<std::uint32_t> core;
  for (const std::uint32_t v : bandBetween(k + 0.38, k + 1.31)) {
    if (isCore(v))
      core.push_back(v);
    if (isThin(v))
      thin.push_back(v);
  }
  std::sort(core.begin(), core.end());
  std::vector<std::uint8_t> in_core;
  std::vector<std::uint32_t> done;
  for (const std::vector<std::uint32_t>& group : connectedGroups(field_.mesh.triangles, core, scratch_)) {
    const std::vector<double> distances = distancesOf(group, lines);
    if (*std::max_element(distances.begin(), distances.end()) <= covered_within + 0.004)
      continue;
    findCoreAxes(field_, group, distances, scratch_, axes);
    done.insert(done.end(), group.begin(), group.end());
  }
  std::sort(done.begin(), done.end());
  LevelGap gap;
  gap.level = k;
  for (const std::uint32_t v : bandBetween(k + 0.5, k + 1.0))
    if (!std::binary_search(done.begin(), done.end(), v))
      gap.nodes.push_back(v);
  for (const std::uint32_t v : thin)
    if (!std::binary_search(done.begin(), done.end(), v))
      gap.nodes.push_back(v);
  std::sort(gap.nodes.begin(), gap.nodes.end());
  gap.distances = distancesOf(gap.nodes, lines);
  for (const std::uint32_t v : bandBetween(k + 1.0, k + 1.0 + neck_depth))
    if (agreement_[v] < neck_agreement && !isThin(v))
      gap.necks.push_back(v);
  std::sort(gap.necks.begin(), gap.necks.end());
  gap.is_above = [&](std::uint32_t v) { return field_.distance[v] >= k + 1.0 && !isThin(v); };
  gap.loop_near = [&](std::uint32_t v) {
    const NearestSegment near = upper.nearest(field_.mesh.positions[v], field_.mesh.metric[v], search_within);
    return near.segment == NearestSegment::none ? near.segment : upper.label(near.segment);
  };
  findFingers(field_, climb_, gap, scratch_, axes);
  return axes;
}

void
LoopMaker::raise(int level, const std::vector<FingerAxis>& axes, const std::vector<std::uint32_t>& thin,
                 std::vector<std::uint32_t>& changed)
{
  SegmentSet lines;
  for (const FingerAxis& axis : axes) {
    lines.add(axis.points, false);
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
      Box box;
      const Eigen::Vector3f p = axis.points[i].cast<float>();
      box.extend(p.data());
      const auto reach = static_cast<float>(axis_reach * longestStepOver(axis.metric[i]));
      blocks_.forBlocksNear(box, reach * reach, [&](std::size_t block) {
        for (std::size_t b = blocks_.blockBegin(block); b < blocks_.blockEnd(block); ++b) {
          const std::uint32_t v = about_[blocks_.originalIndex(b)];
          if (scratch_[v] == 0 && (blocks_.point(b) - p).squaredNorm() <= reach * reach && field_.distance[v] > level - 0.95 &&
              field_.distance[v] < level + 1.5) {
            scratch_[v] = 1;
            changed.push_back(v);
          }
        }
      });
    }
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

void
LoopMaker::addLevel(int k)
{
  std::vector<RawLoop> loops = trace(k + 1, triangles_[k + 1]);
  std::vector<std::uint32_t> thin;
  const std::vector<FingerAxis> axes = findAxes(k, loops, thin);
  loops.erase(std::remove_if(loops.begin(), loops.end(), [](const RawLoop& l) { return l.is_thin; }), loops.end());
  if (!axes.empty()) {
    std::vector<std::uint32_t> changed;
    raise(k + 1, axes, thin, changed);
    std::vector<std::uint32_t> triangles = triangles_[k + 1];
    for (const std::uint32_t v : changed)
      for (std::size_t o = field_.mesh.triangles.outgoingBegin(v); o < field_.mesh.triangles.outgoingBegin(v + 1); ++o)
        triangles.push_back(field_.mesh.triangles.outgoing(o) / 3);
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    loops = trace(k + 1, triangles);
    for (const std::uint32_t v : changed)
      values_[v] = field_.distance[v];
    for (const FingerAxis& axis : axes)
      set_.axes.push_back(axis.points);
  }
  below_.clear();
  below_near_.clear();
  for (const RawLoop& loop : loops) {
    below_near_.emplace_back();
    below_.push_back(finished(loop, below_near_.back()));
    set_.loops.push_back(below_.back());
  }
}

} // namespace

bool
makeScallopLoops(const StepOverDistance& field, const ProgressCallback& progress, ScallopLoopSet& set)
{
  set = ScallopLoopSet();
  return LoopMaker(field, progress, set).run();
}

} // namespace pcl_spiral
