// SPDX-License-Identifier: BSD-3-Clause
#include "support/removed_material.h"

#include "support/move_tree.h"
#include "support/sampling.h"
#include "support/stock.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <omp.h>

namespace pcl_spiral::test {

namespace {

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
placeOf(const AnalyticSurface& surface, const CheckedPath& path, const StockSample& s, double value)
{
  return {value, s.x, surface.rimDistance(s.x), path.turn(s.move), s.move};
}

StockReport
figures(const AnalyticSurface& surface, const CheckedPath& path, const std::vector<StockSample>& samples)
{
  StockReport f;
  std::vector<double> values;
  std::size_t uncut = 0;
  const StockSample* highest = nullptr;
  for (const StockSample& s : samples) {
    if (s.stock == StockSample::not_counted)
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

/** The \p count samples with the most stock, largest first. */
std::vector<StockSample>
highest(std::vector<StockSample> samples, std::size_t count)
{
  count = std::min(count, samples.size());
  std::partial_sort(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count), samples.end(),
                    [](const StockSample& a, const StockSample& b) { return a.stock > b.stock; });
  samples.resize(count);
  return samples;
}

/** Samples half a step-over to both sides of every contact, where the ridges should be. */
std::vector<StockSample>
besidePath(const AnalyticSurface& surface, const CheckedPath& path, const StockField& stock, int threads)
{
  const auto n = static_cast<std::ptrdiff_t>(path.size()) - 1;
  std::vector<StockSample> samples(static_cast<std::size_t>(2 * std::max<std::ptrdiff_t>(n, 0)));
#pragma omp parallel for schedule(dynamic, 512) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const StockSample contact{surface.pulled(path.contacts[at]), 0.0, at, true};
    const Eigen::Vector3d w = stock.across(contact);
    const double half = 0.5 * stock.pitch(contact, w);
    for (int side = 0; side < 2; ++side)
      samples[2 * at + static_cast<std::size_t>(side)] = stock.off(contact, w, side == 0 ? half : -half, true);
  }
  return samples;
}

/** Deepest penetration of the ball along the moves: R minus the distance of its centre to the surface. */
Place
deepestAlongPath(const AnalyticSurface& surface, const CheckedPath& path, const MoveTree& tree, double radius, int threads)
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

RemovalReport
removedMaterial(const AnalyticSurface& surface, const CheckedPath& path, const RemovalSettings& settings)
{
  RemovalReport result;
  if (path.size() < 2)
    return result;
  const int threads = settings.threads > 0 ? settings.threads : omp_get_max_threads();
  result.band = largestStepOver(surface, settings.tool_radius, settings.scallop_height);
  std::vector<Eigen::Vector3d> centres(path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    centres[i] = path.contacts[i] + settings.tool_radius * path.normals[i];
  const MoveTree tree(std::move(centres));
  const StockField stock(surface, tree, settings.tool_radius, settings.scallop_height, result.band);

  const Sampled points = sampleUniform(surface, settings.samples, settings.seed);
  const auto n = static_cast<std::ptrdiff_t>(points.points.size());
  std::vector<StockSample> plain(points.points.size()), ridge(plain.size()), rim(plain.size());
#pragma omp parallel for schedule(dynamic, 128) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const StockSample s = stock.at(points.points[at]);
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

  std::vector<StockSample> tops = highest(besidePath(surface, path, stock, threads), 2000);
  const std::vector<StockSample> from_area = highest(ridge, 200);
  const auto beside = static_cast<std::ptrdiff_t>(tops.size());
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < beside; ++i)
    tops[static_cast<std::size_t>(i)] = stock.climbed(tops[static_cast<std::size_t>(i)]);
  tops = highest(tops, 200);
  tops.insert(tops.end(), from_area.begin(), from_area.end());
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(tops.size()); ++i)
    tops[static_cast<std::size_t>(i)] = stock.followed(tops[static_cast<std::size_t>(i)]);
  const StockReport searched = figures(surface, path, tops);
  if (searched.samples > 0 && searched.max.value > result.ridge.max.value)
    result.ridge.max = searched.max;
  if (searched.uncut_share > 0.0 && result.ridge.uncut_share == 0.0)
    result.ridge.uncut = searched.uncut;

  result.gouge = deepestAlongPath(surface, path, tree, settings.tool_radius, threads);
  for (const std::vector<StockSample>* set : {&plain, &rim})
    for (const StockSample& s : *set)
      if (s.stock != StockSample::not_counted && -s.stock > result.gouge.value)
        result.gouge = placeOf(surface, path, s, -s.stock);
  return result;
}

} // namespace pcl_spiral::test
