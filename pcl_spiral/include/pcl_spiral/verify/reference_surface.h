/** \file
 *  The scan a path is judged by: its surface, its noise, its rim.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/surface/mls_surface.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/search/move_index.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The surface behind the raw points of a scan, by local fits to the points themselves, of the fourth degree and with
 *  false echoes left out (ProjectionMethod::RobustQuartic): not the planner's quadrics, so what those smooth away shows.
 *
 *  Every figure is measured against this surface, not against single points, so the noise of a single point,
 * noise(), is averaged: what remains in the surface is fitNoise(), and no figure is better known than that.
 * Where a planner worked on the same scan, the part of its error that comes from the scan's noise is common
 * to both and does not show; a second scan shows it.
 */
class ReferenceSurface {
public:
  /** Fit \p surface, which stays shared. Boundaries that cannot be found leave it without a rim and with a warning. */
  explicit ReferenceSurface(Surface::ConstPtr surface);
  ReferenceSurface(const ReferenceSurface&) = delete; // the index of the rim refers to it
  ReferenceSurface& operator=(const ReferenceSurface&) = delete;

  const Surface& scanned() const { return *scanned_; }
  const SurfaceGraph& graph() const { return scanned_->graph(); }
  const MlsSurface& surface() const { return surface_; }
  /** Points of the scan that stand alone off the surface, or in specks apart from it. */
  std::size_t strayPoints() const { return scanned_->counts().isolated + scanned_->counts().speck; }

  /** Standard deviation of single points about the surface, mm. On a scan without noise it is what a quadric leaves of
   *  the shape: an upper bound. */
  double noise() const { return surface_.noise(); }
  /** Standard deviation of the surface found, mm. \see MlsSurface::fitNoise */
  double fitNoise() const { return surface_.fitNoise(); }
  /** Radius of one fit: as far as it can be trusted about its foot, mm. */
  double fitRadius() const;

  const std::vector<BoundaryLoop>& loops() const { return loops_; }
  /** Of the outer loop and of the real holes, mm. */
  double rimLength() const { return rim_length_; }
  /** Area between the outermost points and the rim that they stand a little inside of, mm^2. */
  double rimStrip() const { return rim_strip_; }
  /** Distance to the rim (outer loop and real holes), no more than \p limit. */
  double rimDistance(const Eigen::Vector3d& p, double limit) const;
  /** Whether a place on the surface lies inside a gap of the scan, where there is nothing to judge by. */
  bool inGap(const Eigen::Vector3d& p) const;
  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  /** A gap's outline in its mean plane. */
  struct Gap {
    Eigen::Vector3d centre, e1, e2;
    double radius = 0.0;
    std::vector<Eigen::Vector2d> outline;
  };

  void findRim();
  void addGap(const BoundaryLoop& loop);

  Surface::ConstPtr scanned_;
  MlsSurface surface_;
  std::vector<BoundaryLoop> loops_;
  std::vector<Polyline> rims_; ///< closed: the first point comes again
  std::vector<std::unique_ptr<MoveIndex>> rim_index_;
  std::vector<Gap> gaps_;
  double rim_length_ = 0.0, rim_strip_ = 0.0;
  std::vector<std::string> warnings_;
};

/** Statements about what the scan cannot show: the scallop height and the chord error asked for that lie
 * below its noise or below the noise of the surface fitted to it. 0: nothing was asked for. */
std::vector<std::string>
noiseWarnings(const ReferenceSurface& reference, double scallop_height, double chord_error);

} // namespace pcl_spiral
