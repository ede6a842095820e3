#include "path_cover.h"

#include "segment_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double covered = 0.503;     // distance above which a place moves the path
constexpr double aim = 0.49;          // to which it is brought
constexpr double suspect = 0.42;      // a node's distance above which the triangles about it are looked at
constexpr double search_within = 1.5; // step-overs
constexpr double watch_reach = 1.6;   // of a place that is not covered: test points within it are watched
constexpr double moved_reach = 2.2;   // and the path within this may move
constexpr double bell = 0.8;          // half the length of path that one place moves
constexpr double grain = 0.05;        // of the path where it moves
constexpr double damping = 0.7;
constexpr int most_rounds = 24;

/** Places that must not be farther than half a step-over from the path. */
struct TestPoints {
  Polyline points;
  std::vector<StepOverMetric> metric;
  std::vector<double> distances; ///< at most: see bound in Mover
};

class Mover {
public:
  Mover(const StepOverDistance& field, LinkedPath& path) : field_(field), path_(path) {}

  CoverFigures
  run(double held)
  {
    CoverFigures figures;
    gather();
    const TestPoints troubled = select(tests_, [](double d) { return d > covered; });
    figures.places = troubled.points.size();
    figures.farthest_before = figures.farthest =
        troubled.points.empty() ? covered : *std::max_element(troubled.distances.begin(), troubled.distances.end());
    if (troubled.points.empty())
      return figures;
    SegmentSet places;
    for (const Eigen::Vector3d& p : troubled.points)
      places.add({p}, false);
    places.build();
    watch(places);
    densify(places, held);
    for (figures.rounds = 0; figures.rounds < most_rounds; ++figures.rounds)
      if (!moveOnce(figures))
        break;
    return figures;
  }

private:
  template <typename Keep>
  static TestPoints
  select(const TestPoints& from, Keep keep)
  {
    TestPoints kept;
    for (std::size_t i = 0; i < from.points.size(); ++i)
      if (keep(from.distances[i])) {
        kept.points.push_back(from.points[i]);
        kept.metric.push_back(from.metric[i]);
        kept.distances.push_back(from.distances[i]);
      }
    return kept;
  }
  static void
  measure(const SegmentSet& lines, TestPoints& tests)
  {
    tests.distances.resize(tests.points.size());
    const auto count = static_cast<std::int64_t>(tests.points.size());
#pragma omp parallel for schedule(dynamic, 1024)
    for (std::int64_t i = 0; i < count; ++i)
      tests.distances[i] = lines.nearest(tests.points[i], tests.metric[i], search_within).distance;
  }

  void gather();
  void addTriangle(std::size_t triangle, int parts);
  void watch(const SegmentSet& places);
  void densify(const SegmentSet& places, double held);
  bool moveOnce(CoverFigures& figures);

  const StepOverDistance& field_;
  LinkedPath& path_;
  TestPoints tests_;
  std::vector<std::uint8_t> near_;     ///< one a point of the path: 1 within reach of a place that was not covered
  std::vector<std::uint8_t> moves_;    ///< the same, but for those held
  std::vector<double> bounds_;         ///< the test points' distances, with what the path has moved since they were measured
};

/** Middles of the \p parts * \p parts triangles that a triangle is cut into. */
void
Mover::addTriangle(std::size_t triangle, int parts)
{
  const auto& c = field_.mesh.triangles.triangle(triangle);
  const auto add = [&](double a, double b) {
    const double w[3] = {a / parts, b / parts, 1.0 - (a + b) / parts};
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    StepOverMetric m;
    for (int i = 0; i < 3; ++i) {
      p += w[i] * field_.mesh.positions[c[i]];
      m += field_.mesh.metric[c[i]].times(w[i]);
    }
    tests_.points.push_back(p);
    tests_.metric.push_back(m);
  };
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j) {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < parts)
        add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
}

void
Mover::gather()
{
  SegmentSet line;
  line.add(path_.points, false);
  line.build();
  TestPoints nodes;
  std::vector<std::uint32_t> index(field_.mesh.size(), 0xffffffffu);
  for (std::uint32_t v = 0; v < field_.mesh.size(); ++v)
    if (field_.is_fine[v]) {
      index[v] = static_cast<std::uint32_t>(nodes.points.size());
      nodes.points.push_back(field_.mesh.positions[v]);
      nodes.metric.push_back(field_.mesh.metric[v]);
    }
  measure(line, nodes);
  const int coarse_parts = std::max(1, static_cast<int>(std::ceil(4.0 * field_.usual_edge)));
  for (std::size_t t = 0; t < field_.mesh.triangles.triangleCount(); ++t) {
    const auto& c = field_.mesh.triangles.triangle(t);
    if (index[c[0]] == 0xffffffffu || index[c[1]] == 0xffffffffu || index[c[2]] == 0xffffffffu) {
      if (field_.is_weak[t])
        addTriangle(t, coarse_parts);
    }
    else if (std::max({nodes.distances[index[c[0]]], nodes.distances[index[c[1]]], nodes.distances[index[c[2]]]}) > suspect)
      addTriangle(t, 2);
  }
  tests_.points.insert(tests_.points.end(), path_.links.begin(), path_.links.end());
  tests_.metric.insert(tests_.metric.end(), path_.link_metric.begin(), path_.link_metric.end());
  measure(line, tests_);
  tests_.points.insert(tests_.points.end(), nodes.points.begin(), nodes.points.end());
  tests_.metric.insert(tests_.metric.end(), nodes.metric.begin(), nodes.metric.end());
  tests_.distances.insert(tests_.distances.end(), nodes.distances.begin(), nodes.distances.end());
}

void
Mover::watch(const SegmentSet& places)
{
  const auto count = static_cast<std::int64_t>(tests_.points.size());
  TestPoints watched = std::move(tests_);
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::int64_t i = 0; i < count; ++i)
    if (watched.distances[i] < 0.36 ||
        places.nearest(watched.points[i], watched.metric[i], watch_reach).segment == NearestSegment::none)
      watched.distances[i] = -1.0;
  tests_ = select(watched, [](double d) { return d >= 0.0; });
  bounds_ = tests_.distances;
}

void
Mover::densify(const SegmentSet& places, double held)
{
  const std::size_t n = path_.points.size();
  std::vector<std::uint8_t> near(n, 0);
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::size_t i = 0; i < n; ++i)
    near[i] = places.nearest(path_.points[i], path_.metric[i], moved_reach).segment != NearestSegment::none;
  LinkedPath dense;
  double travelled = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double step = 0.0;
    if (i > 0)
      step = between(path_.metric[i - 1], path_.metric[i], 0.5).length(path_.points[i] - path_.points[i - 1]);
    const bool inside = i > 0 && (near[i] || near[i - 1]);
    const int parts = inside ? std::max(1, static_cast<int>(std::ceil(step / grain))) : 1;
    for (int k = i > 0 ? 1 : parts; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      const std::size_t before = i > 0 ? i - 1 : i;
      dense.points.push_back((1.0 - share) * path_.points[before] + share * path_.points[i]);
      dense.metric.push_back(between(path_.metric[before], path_.metric[i], share));
      dense.reversed.push_back(path_.reversed[i]);
      dense.turns.push_back(path_.turns[before] + static_cast<float>(share) * (path_.turns[i] - path_.turns[before]));
      near_.push_back(near[i] || inside);
      moves_.push_back(near_.back() && travelled + share * step > held);
    }
    travelled += step;
  }
  path_.points = std::move(dense.points);
  path_.metric = std::move(dense.metric);
  path_.reversed = std::move(dense.reversed);
  path_.turns = std::move(dense.turns);
}

bool
Mover::moveOnce(CoverFigures& figures)
{
  SegmentSet lines;
  const std::size_t n = path_.points.size();
  const auto counts = [this, n](std::size_t i) { return near_[i] || (i > 0 && near_[i - 1]) || (i + 1 < n && near_[i + 1]); };
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i;
    while (end < n && counts(end))
      ++end;
    if (end > i)
      lines.add(Polyline(path_.points.begin() + static_cast<std::ptrdiff_t>(i), path_.points.begin() + static_cast<std::ptrdiff_t>(end)), false, i);
    i = std::max(end, i + 1);
  }
  if (lines.empty())
    return false;
  lines.build();
  std::vector<NearestSegment> found(tests_.points.size());
  const auto count = static_cast<std::int64_t>(tests_.points.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < count; ++i)
    if (bounds_[i] > covered) {
      found[i] = lines.nearest(tests_.points[i], tests_.metric[i], search_within);
      bounds_[i] = found[i].distance;
    }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tests_.points.size(); ++i)
    if (bounds_[i] > covered && found[i].segment != NearestSegment::none)
      open.push_back(i);
  std::sort(open.begin(), open.end(), [this](std::size_t a, std::size_t b) { return bounds_[a] != bounds_[b] ? bounds_[a] > bounds_[b] : a < b; });
  figures.left = open.size();
  figures.farthest = open.empty() ? covered : bounds_[open.front()];
  if (open.empty())
    return false;
  figures.farthest_place = tests_.points[open.front()];
  std::vector<Eigen::Vector3d> shift(n, Eigen::Vector3d::Zero());
  std::vector<std::uint8_t> taken(n, 0);
  const auto reach = static_cast<std::size_t>(bell / grain);
  for (const std::size_t i : open) {
    const NearestSegment& near = found[i];
    const std::size_t centre = lines.label(near.segment) + lines.place(near.segment) + (near.share > 0.5 ? 1 : 0);
    const std::size_t low = centre > reach ? centre - reach : 0, high = std::min(n - 1, centre + reach);
    if (std::any_of(taken.begin() + static_cast<std::ptrdiff_t>(std::max(low, centre - std::min(centre, reach / 3))),
                    taken.begin() + static_cast<std::ptrdiff_t>(std::min(high, centre + reach / 3) + 1), [](std::uint8_t t) { return t != 0; }))
      continue;
    taken[centre] = 1;
    const Eigen::Vector3d foot = (1.0 - near.share) * lines.point(near.segment) + near.share * lines.point(near.segment + 1);
    const Eigen::Vector3d pull = (tests_.points[i] - foot) * ((near.distance - aim) / near.distance);
    for (std::size_t k = low; k <= high; ++k)
      if (moves_[k])
        shift[k] += pull * (0.5 * (1.0 + std::cos(M_PI * (static_cast<double>(k) - static_cast<double>(centre)) / (static_cast<double>(reach) + 1.0))));
  }
  double farthest = 0.0;
  for (std::size_t k = 0; k < n; ++k)
    if (moves_[k] && !shift[k].isZero()) {
      path_.points[k] += damping * shift[k];
      farthest = std::max(farthest, path_.metric[k].length(damping * shift[k]));
    }
  for (double& b : bounds_)
    b += farthest;
  return farthest > 0.0;
}

} // namespace

CoverFigures
coverPath(const StepOverDistance& field, double held, LinkedPath& path)
{
  return Mover(field, path).run(held);
}

} // namespace pcl_spiral
