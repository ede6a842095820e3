#include "support/removed_material.h"

#include "support/move_tree.h"
#include "support/sampling.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <omp.h>

namespace pcl_spiral::test {

namespace {

constexpr double outside = -1e9; ///< stock where samples do not count

/** A surface sample and the stock over it. */
struct Sample {
  Eigen::Vector3d x;
  double stock = outside;
  std::size_t move = 0;
  bool met = false;
};

class Stock {
public:
  Stock(const AnalyticSurface& surface, const MoveTree& tree, const RemovalSettings& s, double band)
      : surface_(surface), tree_(tree), radius_(s.tool_radius), h_(s.scallop_height), band_(band)
  {
  }

  bool
  main(const Eigen::Vector3d& x) const
  {
    return surface_.contains(x) && surface_.rimDistance(x) >= band_;
  }

  Sample
  at(const Eigen::Vector3d& x) const
  {
    const Eigen::Vector3d n = surface_.normal(x);
    const double start =
        0.2 * h_; // a short ray is quick; one that starts within the cut is cast anew from deeper
    MoveTree::Entry entry = tree_.entry(x, n, radius_, start, 20.0 * h_);
    if (entry.met && entry.t <= -start)
      entry = tree_.entry(x, n, radius_, radius_, 20.0 * h_);
    return {x, entry.t, entry.move, entry.met};
  }

  /** Direction across the feed at a sample: along the surface, normal to the move met there. */
  Eigen::Vector3d
  across(const Sample& s) const
  {
    const Eigen::Vector3d n = surface_.normal(s.x);
    const Eigen::Vector3d feed = tree_.points()[s.move + 1] - tree_.points()[s.move];
    const Eigen::Vector3d w = n.cross(feed);
    return w.norm() > 1e-12 ? Eigen::Vector3d(w.normalized()) : Eigen::Vector3d(n.unitOrthogonal());
  }

  /** Stock a distance \p d off along \p w; outside when that place is not in the main area. */
  Sample
  off(const Sample& from, const Eigen::Vector3d& w, double d, bool near_rim) const
  {
    const Eigen::Vector3d x = surface_.pulled(from.x + d * w);
    return near_rim && !main(x) ? Sample{x} : at(x);
  }

  double
  pitch(const Sample& s, const Eigen::Vector3d& w) const
  {
    return exactStepOver(radius_, h_, surface_.normalCurvature(s.x, w));
  }

  /** Golden section for the largest stock between the offsets lo and hi along w. */
  Sample
  golden(const Sample& from, const Eigen::Vector3d& w, double lo, double hi, bool near_rim, int rounds) const
  {
    constexpr double g = 0.6180339887498949;
    double a = hi - g * (hi - lo), b = lo + g * (hi - lo);
    Sample fa = off(from, w, a, near_rim), fb = off(from, w, b, near_rim);
    for (int i = 0; i < rounds; ++i)
      if (fa.stock > fb.stock) {
        hi = b;
        b = a;
        fb = fa;
        a = hi - g * (hi - lo);
        fa = off(from, w, a, near_rim);
      }
      else {
        lo = a;
        a = b;
        fa = fb;
        b = lo + g * (hi - lo);
        fb = off(from, w, b, near_rim);
      }
    return fa.stock > fb.stock ? fa : fb;
  }

  /** Climb across the feed to the top of the ridge. */
  Sample
  climbed(const Sample& start) const
  {
    if (!start.met)
      return start;
    Eigen::Vector3d w = across(start);
    const double s = pitch(start, w), step = 0.1 * s;
    const bool near_rim = surface_.rimDistance(start.x) < band_ + 1.5 * s;
    Sample best = off(start, w, step, near_rim);
    const Sample back = off(start, w, -step, near_rim);
    if (back.stock > best.stock) {
      w = -w;
      best = back;
    }
    double d = best.stock > start.stock ? step : 0.0;
    for (int i = 0; d > 0.0 && i < 12; ++i) {
      const Sample next = off(start, w, d + step, near_rim);
      if (next.stock <= best.stock)
        break;
      best = next;
      d += step;
    }
    const Sample top = golden(start, w, d - step, d + step, near_rim, 15);
    return top.stock > std::max(best.stock, start.stock) ? top : best.stock > start.stock ? best : start;
  }

  /** Follow the ridge both ways by a move's length for its highest place. */
  Sample
  followed(const Sample& ridge) const
  {
    if (!ridge.met)
      return ridge;
    const Eigen::Vector3d w = across(ridge), along = w.cross(surface_.normal(ridge.x));
    const double s = pitch(ridge, w);
    const double reach = (tree_.points()[ridge.move + 1] - tree_.points()[ridge.move]).norm();
    const auto top = [&](double d) {
      const Sample moved = off(ridge, along, d, true);
      return moved.stock == outside ? moved : golden(moved, w, -0.2 * s, 0.2 * s, true, 14);
    };
    Sample best = ridge;
    double at = 0.0;
    for (double step = reach / 4.0; step > reach / 200.0; step /= 4.0) {
      const double centre = at;
      for (int k = -4; k <= 4; ++k) {
        const Sample candidate = top(centre + k * step);
        if (candidate.stock > best.stock) {
          best = candidate;
          at = centre + k * step;
        }
      }
    }
    return best;
  }

private:
  const AnalyticSurface& surface_;
  const MoveTree& tree_;
  double radius_, h_, band_;
};

/** Largest exact step-over over all places and directions, from a grid over the region. */
double
largestStepOver(const AnalyticSurface& surface, double radius, double h)
{
  double largest = 0.0;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j) {
      const Eigen::Vector2d span = surface.region().upper() - surface.region().lower();
      const Eigen::Vector2d u = surface.region().lower() + span.cwiseProduct(Eigen::Vector2d(i, j) / 60.0);
      if (!surface.region().contains(u))
        continue;
      const double least = surface.principalCurvatures(surface.lift(u)).first;
      if (least * radius > -0.95)
        largest = std::max(largest, exactStepOver(radius, h, least));
    }
  return largest;
}

Place
placeOf(const AnalyticSurface& surface, const CheckedPath& path, const Sample& s, double value)
{
  return {value, s.x, surface.rimDistance(s.x), path.turn(s.move), s.move};
}

StockFigures
figures(const AnalyticSurface& surface, const CheckedPath& path, const std::vector<Sample>& samples)
{
  StockFigures f;
  std::vector<double> values;
  std::size_t uncut = 0;
  const Sample* highest = nullptr;
  for (const Sample& s : samples) {
    if (s.stock == outside)
      continue;
    values.push_back(s.stock);
    if (!s.met && uncut++ == 0)
      f.uncut = placeOf(surface, path, s, 0.0);
    if (!highest || s.stock > highest->stock)
      highest = &s;
  }
  f.samples = values.size();
  if (!highest)
    return f;
  f.max = placeOf(surface, path, *highest, highest->stock);
  f.uncut_share = f.uncut.value = static_cast<double>(uncut) / static_cast<double>(values.size());
  f.p50 = quantile(values, 0.5);
  f.p90 = quantile(values, 0.9);
  f.p99 = quantile(values, 0.99);
  f.p999 = quantile(values, 0.999);
  return f;
}

/** The \p count samples of the most stock, most first. */
std::vector<Sample>
highest(std::vector<Sample> samples, std::size_t count)
{
  count = std::min(count, samples.size());
  std::partial_sort(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count), samples.end(),
                    [](const Sample& a, const Sample& b) { return a.stock > b.stock; });
  samples.resize(count);
  return samples;
}

/** Samples half a step-over to both sides of every contact, where the ridges should be. */
std::vector<Sample>
besidePath(const AnalyticSurface& surface, const CheckedPath& path, const Stock& stock, int threads)
{
  const auto n = static_cast<std::ptrdiff_t>(path.size()) - 1;
  std::vector<Sample> samples(static_cast<std::size_t>(2 * std::max<std::ptrdiff_t>(n, 0)));
#pragma omp parallel for schedule(dynamic, 512) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Sample contact{surface.pulled(path.contacts[at]), 0.0, at, true};
    const Eigen::Vector3d w = stock.across(contact);
    const double half = 0.5 * stock.pitch(contact, w);
    for (int side = 0; side < 2; ++side)
      samples[2 * at + static_cast<std::size_t>(side)] =
          stock.off(contact, w, side == 0 ? half : -half, true);
  }
  return samples;
}

/** Deepest penetration of the ball along the moves: R less the distance of its centre to the surface. */
Place
deepestAlongPath(const AnalyticSurface& surface, const CheckedPath& path, const MoveTree& tree, double radius,
                 int threads)
{
  const auto moves = static_cast<std::ptrdiff_t>(tree.moves());
  const auto depth = [&](std::size_t i, double f) {
    return radius - surface.signedDistance((1.0 - f) * tree.points()[i] + f * tree.points()[i + 1]);
  };
  std::vector<double> coarse(tree.moves());
#pragma omp parallel for schedule(dynamic, 512) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < moves; ++i) {
    const auto at = static_cast<std::size_t>(i);
    coarse[at] = std::max(depth(at, 0.0), depth(at, 0.5));
  }
  coarse.back() = std::max(coarse.back(), depth(tree.moves() - 1, 1.0));
  std::vector<std::size_t> order(tree.moves());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t count = std::min<std::size_t>(order.size(), 1000);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) { return coarse[a] > coarse[b]; });
  Place deepest;
  deepest.value = -radius;
  for (std::size_t k = 0; k < count; ++k)
    for (int j = 0; j <= 16; ++j) {
      const double f = j / 16.0, d = depth(order[k], f);
      if (d <= deepest.value)
        continue;
      deepest.value = d;
      deepest.index = order[k];
      deepest.at = surface.closest((1.0 - f) * tree.points()[order[k]] + f * tree.points()[order[k] + 1]);
    }
  deepest.rim = surface.rimDistance(deepest.at);
  deepest.turn = path.turn(deepest.index);
  return deepest;
}

} // namespace

RemovalFigures
removedMaterial(const AnalyticSurface& surface, const CheckedPath& path, const RemovalSettings& settings)
{
  RemovalFigures result;
  if (path.size() < 2)
    return result;
  const int threads = settings.threads > 0 ? settings.threads : omp_get_max_threads();
  result.band = largestStepOver(surface, settings.tool_radius, settings.scallop_height);
  std::vector<Eigen::Vector3d> centres(path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    centres[i] = path.contacts[i] + settings.tool_radius * path.normals[i];
  const MoveTree tree(std::move(centres));
  const Stock stock(surface, tree, settings, result.band);

  const Sampled points = sampleUniform(surface, settings.samples, settings.seed);
  const auto n = static_cast<std::ptrdiff_t>(points.points.size());
  std::vector<Sample> plain(points.points.size()), ridge(plain.size()), rim(plain.size());
#pragma omp parallel for schedule(dynamic, 128) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Sample s = stock.at(points.points[at]);
    if (surface.rimDistance(s.x) < result.band)
      rim[at] = s;
    else {
      plain[at] = s;
      ridge[at] = stock.climbed(s);
    }
  }
  result.stock = figures(surface, path, plain);
  result.ridge = figures(surface, path, ridge);
  result.rim = figures(surface, path, rim);

  std::vector<Sample> tops = highest(besidePath(surface, path, stock, threads), 2000);
  const std::vector<Sample> from_area = highest(ridge, 200);
  const auto beside = static_cast<std::ptrdiff_t>(tops.size());
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < beside; ++i)
    tops[static_cast<std::size_t>(i)] = stock.climbed(tops[static_cast<std::size_t>(i)]);
  tops = highest(tops, 200);
  tops.insert(tops.end(), from_area.begin(), from_area.end());
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(tops.size()); ++i)
    tops[static_cast<std::size_t>(i)] = stock.followed(tops[static_cast<std::size_t>(i)]);
  const StockFigures searched = figures(surface, path, tops);
  if (searched.samples > 0 && searched.max.value > result.ridge.max.value)
    result.ridge.max = searched.max;
  if (searched.uncut_share > 0.0 && result.ridge.uncut_share == 0.0)
    result.ridge.uncut = searched.uncut;

  result.gouge = deepestAlongPath(surface, path, tree, settings.tool_radius, threads);
  for (const std::vector<Sample>* set : {&plain, &rim})
    for (const Sample& s : *set)
      if (s.stock != outside && -s.stock > result.gouge.value)
        result.gouge = placeOf(surface, path, s, -s.stock);
  return result;
}

} // namespace pcl_spiral::test
