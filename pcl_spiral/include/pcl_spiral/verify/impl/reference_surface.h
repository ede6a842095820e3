// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scan or mesh by which a path is judged: its surface, its noise, its rim.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/search/impl/move_index.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/verify/impl/reference_mesh.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** The surface behind the raw points of a scan, from local fits of the fourth degree
 *  to the points, without false echoes (ProjectionMethod::RobustQuartic). These
 *  are not the quadrics of the planner: it sees what the planner smooths away.
 *
 *  All figures are measured against this surface, not against single points. So the noise of a
 *  single point, noise(), is averaged. What remains in the surface is fitNoise(); no figure is
 *  known better than that. If the planner worked on the same scan, both share the error that
 *  comes from the noise of the scan, and this error does not show. A second scan shows it.
 *
 *  Of a mesh, the points are samples of its curved surface, without noise; fitNoise() is the
 *  distance of the fits from them. The rims are those of the mesh, its holes are real, and
 *  it has no gaps. At creases the fits round the sharp edges: that band is kept separate. */
class ReferenceSurface {
public:
  /** Fits \p surface, which stays shared. If the boundaries cannot be found, there is no rim, and a warning reports it. */
  explicit ReferenceSurface(Surface::ConstPtr surface);
  /** Fits the samples of \p mesh. Fails if they make no surface, see ScannedSurface, or if \p progress cancels. */
  static Status make(const ReferenceMesh::ConstPtr& mesh, const ProgressCallback& progress,
                     std::shared_ptr<const ReferenceSurface>& result);
  ReferenceSurface(const ReferenceSurface&) = delete; // the index of the rim refers to it
  ReferenceSurface& operator=(const ReferenceSurface&) = delete;

  const Surface& scanned() const { return *scanned_; }
  const SurfaceGraph& graph() const { return scanned_->graph(); }
  /** Null for a scan. */
  const ReferenceMesh* mesh() const { return mesh_.get(); }
  const MlsSurface& surface() const { return surface_; }
  /** Outliers of the scan: isolated points off the surface, or in small clusters apart from it. */
  std::size_t outlierPoints() const { return scanned_->report().offSurface(); }

  /** Standard deviation of single points about the surface, mm. On a scan without
   *  noise: what a quadric leaves of the shape, an upper bound. 0 for a mesh. */
  double noise() const { return mesh_ ? 0.0 : surface_.noise(); }
  /** Standard deviation of the fitted surface, mm. \see MlsSurface::fitNoise. For a
   *  mesh: the rms distance of its samples from the fitted surface, off the creases. */
  double fitNoise() const { return mesh_ ? mesh_misfit_ : surface_.fitNoise(); }
  /** Radius of one fit: how far it can be trusted about its foot, mm. */
  double fitRadius() const;

  const std::vector<BoundaryLoop>& loops() const { return loops_; }
  /** Length of the outer loop and of the real holes, mm. */
  double rimLength() const { return rim_length_; }
  /** Area between the outermost points and the rim, which lies a little outside them, mm^2. */
  double rimStrip() const { return rim_strip_; }
  /** Distance to the rim (outer loop and real holes), at most \p limit. */
  double rimDistance(const Eigen::Vector3d& p, double limit) const;
  /** The same, and to the line through the outermost points. */
  double outermostDistance(const Eigen::Vector3d& p, double limit) const;
  /** The place of the rim nearest to \p p, if it is nearer than \p limit. */
  std::optional<Eigen::Vector3d> nearestOnRim(const Eigen::Vector3d& p, double limit) const;
  /** Whether a place on the surface lies inside a gap of the scan, where there is no data to judge by. */
  bool inGap(const Eigen::Vector3d& p) const;
  /** Half the width of the band about the creases of a mesh, mm: the reach of a fit; 0 without creases. */
  double creaseBand() const { return crease_band_; }
  bool inCreaseBand(const Eigen::Vector3d& p) const
  {
    return crease_band_ > 0.0 && mesh_->creases().distance(p, crease_band_) < crease_band_;
  }
  /** Position and normal of point \p i of the graph on the mesh: its sample, not the fit; flat. */
  SurfaceFoot meshPlace(std::size_t i) const;
  const Diagnostics& warnings() const { return warnings_; }

private:
  ReferenceSurface(Surface::ConstPtr surface, ReferenceMesh::ConstPtr mesh);
  /** The outline of a gap in its mean plane. */
  struct Gap {
    Eigen::Vector3d centre, e1, e2;
    double radius = 0.0;
    std::vector<Eigen::Vector2d> outline;
  };

  void findRim();
  void takeRims();
  void measureMisfit();
  void indexRims();
  void addGap(const BoundaryLoop& loop);

  Surface::ConstPtr scanned_;
  ReferenceMesh::ConstPtr mesh_;
  double crease_band_ = 0.0, mesh_misfit_ = 0.0;
  MlsSurface surface_;
  std::vector<BoundaryLoop> loops_;
  std::vector<Polyline> rims_; ///< closed: the first point is repeated at the end
  std::vector<std::unique_ptr<MoveIndex>> rim_index_;
  std::vector<Polyline> outermost_; ///< lines through the outermost points, closed as rims_
  std::vector<std::unique_ptr<MoveIndex>> outermost_index_;
  std::vector<Gap> gaps_;
  double rim_length_ = 0.0, rim_strip_ = 0.0;
  Diagnostics warnings_;
};

/** Warnings about what the scan cannot show: the scallop height and the chord error
 *  asked for, if they are below its noise or below the noise of the surface fitted
 *  to it; for a mesh, below three times the latter. 0: nothing was asked for. */
Diagnostics noiseWarnings(const ReferenceSurface& reference, double scallop_height, double chord_error);

} // namespace pcl_spiral
