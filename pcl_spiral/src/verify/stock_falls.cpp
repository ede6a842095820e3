// SPDX-License-Identifier: BSD-3-Clause
#include "verify/stock_falls.h"

#include "common/stoppable_loop.h"
#include "verify/move_order.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double fallen = 5e-4;            // mm: so near to its remaining height a place has fallen
constexpr std::int64_t places_a_call = 64; // that one call does the work of

/** The falls over one place. */
class PlaceFalls {
public:
  PlaceFalls(const CutterSweep& sweep, const MoveOrder& order, const StockFallSettings& settings)
  : sweep_(sweep), order_(order), settings_(settings)
  {}

  void find(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal, double left, std::vector<StockFall>& falls) const
  {
    double height = settings_.reach, kept = height;
    StockFall last;
    const double start = std::max(settings_.shallow, fallen - left);
    const auto reach = [&] { return sweep_.boundingRadius() + std::max(height, start); };
    order_.search(foot, reach, [&](std::size_t move) {
      if (!sweep_.enter(move, foot, normal, start, height))
        return true;
      last = {static_cast<std::uint32_t>(move), static_cast<float>(std::max(height, left))};
      const bool done = height <= left + fallen;
      if (done || kept - height >= settings_.step) {
        falls.push_back(last);
        kept = height;
      }
      return !done;
    });
    if (height < kept)
      falls.push_back(last);
  }

private:
  const CutterSweep& sweep_;
  const MoveOrder& order_;
  const StockFallSettings& settings_;
};

} // namespace

float
StockFalls::heightAfter(std::size_t place, std::size_t moves) const
{
  const auto first = falls.begin() + begins[place], end = falls.begin() + begins[place + 1];
  const auto next = std::partition_point(first, end, [moves](const StockFall& fall) { return fall.move < moves; });
  return next == first ? reach : std::prev(next)->height;
}

StockFalls
stockFalls(const StockMesh& mesh, const CutterSweep& sweep, const StockFallSettings& settings, const std::function<bool(double)>& progress)
{
  StockFalls result;
  result.reach = static_cast<float>(settings.reach);
  const MoveOrder order(sweep.centres());
  const PlaceFalls at(sweep, order, settings);
  const auto places = static_cast<std::int64_t>(mesh.places.size()), runs = (places + places_a_call - 1) / places_a_call;
  std::vector<std::vector<StockFall>> found(runs);
  std::vector<std::uint32_t> counts(places);
  const auto work = [&](std::int64_t r) {
    for (std::int64_t i = r * places_a_call; i < std::min(places, (r + 1) * places_a_call); ++i) {
      const Eigen::Vector3d normal = mesh.normals[i].cast<double>().normalized();
      const double left = mesh.stock[i];
      const std::size_t before = found[r].size();
      at.find(mesh.places[i].cast<double>() - left * normal, normal, left, found[r]);
      counts[i] = static_cast<std::uint32_t>(found[r].size() - before);
    }
  };
  if (!stoppableLoop(0, runs, progress, work, places_a_call))
    return result;
  result.begins.assign(1, 0);
  for (const std::uint32_t count : counts)
    result.begins.push_back(result.begins.back() + count);
  result.falls.reserve(result.begins.back());
  for (const std::vector<StockFall>& run : found)
    result.falls.insert(result.falls.end(), run.begin(), run.end());
  return result;
}

FallOrder::FallOrder(const StockFalls& falls)
{
  entries_.reserve(falls.falls.size());
  for (std::size_t place = 0; place < falls.places(); ++place)
    for (std::uint32_t i = falls.begins[place]; i < falls.begins[place + 1]; ++i)
      entries_.push_back({falls.falls[i].move, static_cast<std::uint32_t>(place)});
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.move < b.move; });
}

void
FallOrder::update(const StockFalls& falls, std::size_t from, std::size_t to, std::vector<float>& heights,
                  const std::function<void(std::size_t)>& changed) const
{
  const auto atMove = [this](std::size_t moves) {
    return std::partition_point(entries_.begin(), entries_.end(), [moves](const Entry& entry) { return entry.move < moves; });
  };
  const auto end = atMove(std::max(from, to));
  for (auto entry = atMove(std::min(from, to)); entry < end; ++entry) {
    heights[entry->place] = falls.heightAfter(entry->place, to);
    changed(entry->place);
  }
}

} // namespace pcl_spiral
