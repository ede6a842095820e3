// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Stock, ridges and gouges over the places of one chunk. Private to verify.
 */
#pragma once

#include "stock_field.h"

#include <pcl_spiral/surface/impl/ball_reach.h>

#include <pcl_spiral/verify/impl/material_removal_engine.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The zone in which a sample counts. */
enum class Zone : std::uint8_t { None, Main, Rim, Crease, Unreached };

/** The extremes found, in a fixed order. */
struct RemovalExtremes {
  static constexpr double none = -1e300; ///< below every height
  PlacedValue stock{none, Eigen::Vector3d::Zero(), 0}, scallop = stock, rim = stock, crease = stock, unreached = stock;
  PlacedValue gouge, rim_gouge, crease_gouge, face_depth, face_gouge;
  void merge(const RemovalExtremes& later);
};

/** Stock and ridge over one reference point. */
struct SampleResult {
  Zone zone = Zone::None;
  bool met = false;
  float stock = 0.0f, ridge = 0.0f; ///< NaN: none
  float step = 0.0f;                ///< the largest step-over there
  std::size_t move = 0;
};

/** Measures places one by one. */
class RemovalSampler {
public:
  /** \p ball: what the cutter reaches; null: everything. */
  RemovalSampler(const ReferenceSurface& reference, const CutterSweep& sweep, const RemovalSettings& settings, double reach,
                 const BallReach* ball);

  /** Over the foot of a reference point; for one in the crease band over its place in the mesh. \p guess: the move tried first; it becomes
   *  the move found. */
  SampleResult at(const SurfaceFoot& foot, std::size_t& guess, RemovalExtremes& extremes) const;
  /** How deep the cutter is below the flat face of point \p i of the samples of a mesh. \p move: named as the one that cuts there. */
  void inFace(std::size_t i, std::size_t move, RemovalExtremes& extremes) const;
  /** The ridge on one side, 1 or -1, of a place on the path. */
  void beside(const SurfaceFoot& foot, std::size_t move, double side, RemovalExtremes& extremes) const;
  /** The deepest gouge on a move between the shares \p f0 and \p f1, searched with the fits at both ends. */
  void along(std::size_t move, double f0, double f1, const SurfaceFoot& foot0, const SurfaceFoot& foot1, RemovalExtremes& extremes) const;

private:
  double largestStep(const SurfaceFoot& foot) const;
  double stepAcross(const SurfaceFoot& foot, const Eigen::Vector3d& w) const;
  /** The depth that the cutter cuts off the surface next to \p place; off \p nearest if there is no surface. */
  void takeGouge(std::size_t move, double f, const SurfaceFoot& nearest, const Eigen::Vector3d& place, RemovalExtremes& extremes) const;
  bool leavesPart(const SurfaceFoot& foot, double depth) const;
  bool grazesBall(const SurfaceFoot& foot, double depth) const;
  /** The stock at a foot; where its ray does not show how deep the cutter is, the depth of the foot in it. */
  Stock stockAt(const SurfaceFoot& foot, std::size_t guess) const;
  Zone zoneOf(const SurfaceFoot& foot, const Eigen::Vector3d& position, double step) const;
  void takeRidge(const SurfaceFoot& foot, const Ridge& ridge, double step, RemovalExtremes& extremes, float* height) const;

  const ReferenceSurface& reference_;
  const CutterSweep& sweep_;
  const RemovalSettings& settings_;
  const BallReach* ball_;
  double step_radius_;
  StockField field_;
  double fit_radius_;
};

} // namespace pcl_spiral
