// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  When the stock over each place of a surface falls, and to which height.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/verify/impl/cutter_sweep.h>
#include <pcl_spiral/verify/stock_mesh.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** Lengths in mm. */
struct StockFallSettings {
  double reach = 1.0;    ///< height of the stock before the first move: RemovalReport::reach
  double shallow = 0.01; ///< where rays start below the surface, at least; see StockField
  double step = 0.02;    ///< a fall by less waits for the next one; the last one does not wait
};

/** One fall. */
struct StockFall {
  std::uint32_t move = 0; ///< at whose end the stock is as low as this
  float height = 0.0f;    ///< above the surface, mm; negative: gouge
};

/** The falls over places, those of each in order. Memory: 8 bytes a fall, at most reach / step + 2 a place. */
struct StockFalls {
  float reach = 0.0f;                ///< height of every place before its first fall, mm
  std::vector<std::uint32_t> begins; ///< first fall of each place, and the number of all
  std::vector<StockFall> falls;

  std::size_t places() const { return begins.empty() ? 0 : begins.size() - 1; }
  /** Height over \p place after the first \p moves moves, mm. */
  float heightAfter(std::size_t place, std::size_t moves) const;
};

/** The stock that \p sweep leaves over the places of \p mesh after each of its moves. MaterialRemoval measures it after the last: there it
 *  is within half a micrometre of \p mesh, and never below it, as the judge counts gouges beside a rim less deep than a ray does. Parallel;
 *  the same for any number of threads. \p progress gets the share done; false cancels, and no falls are left. */
StockFalls stockFalls(const StockMesh& mesh, const CutterSweep& sweep, const StockFallSettings& settings,
                      const std::function<bool(double)>& progress = {});

/** Falls of all places in the order of their moves, to go on from one moment to the next. Memory: 8 bytes a fall. */
class FallOrder {
public:
  explicit FallOrder(const StockFalls& falls);

  /** Sets \p heights from those after \p from moves to those after \p to, and calls \p changed(place) for each that may differ; a place may
   *  come twice. */
  void update(const StockFalls& falls, std::size_t from, std::size_t to, std::vector<float>& heights,
              const std::function<void(std::size_t)>& changed) const;

private:
  struct Entry {
    std::uint32_t move, place;
  };
  std::vector<Entry> entries_;
};

} // namespace pcl_spiral
