/** \file
 *  The scan or mesh a path is judged by: its surface, its noise, its rim.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/surface/impl/mls_surface.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/search/impl/move_index.h>
#include <pcl_spiral/verify/impl/reference_mesh.h>

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
 *
 *  Of a mesh the points are samples of its curved surface, without noise; fitNoise() is how far the fits are off them. Its rims
 *  are those of the mesh, its holes real, and nothing lies in a gap. About creases the fits round what is sharp: that band is
 *  kept apart.
 */
class ReferenceSurface {
public:
  /** Fit \p surface, which stays shared. Boundaries that cannot be found leave it without a rim and with a warning. */
  explicit ReferenceSurface(Surface::ConstPtr surface);
  /** Fit the samples of \p mesh. Fails where they make no surface, see ScannedSurface; cancelled by \p progress. */
  static Status make(const ReferenceMesh::ConstPtr& mesh, const ProgressCallback& progress,
                     std::shared_ptr<const ReferenceSurface>& result);
  ReferenceSurface(const ReferenceSurface&) = delete; // the index of the rim refers to it
  ReferenceSurface& operator=(const ReferenceSurface&) = delete;

  const Surface& scanned() const { return *scanned_; }
  const SurfaceGraph& graph() const { return scanned_->graph(); }
  /** Null where it is a scan. */
  const ReferenceMesh* mesh() const { return mesh_.get(); }
  const MlsSurface& surface() const { return surface_; }
  /** Points of the scan that stand alone off the surface, or in specks apart from it. */
  std::size_t strayPoints() const { return scanned_->counts().isolated + scanned_->counts().speck; }

  /** Standard deviation of single points about the surface, mm. On a scan without noise it is what a quadric leaves of
   *  the shape: an upper bound. Of a mesh 0. */
  double noise() const { return mesh_ ? 0.0 : surface_.noise(); }
  /** Standard deviation of the surface found, mm. \see MlsSurface::fitNoise. Of a mesh the distance, rms, of its samples from it,
   *  off the creases. */
  double fitNoise() const { return mesh_ ? mesh_misfit_ : surface_.fitNoise(); }
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
  /** Half the width of the band about the creases of a mesh, mm: as far as a fit reaches; 0 without creases. */
  double creaseBand() const { return crease_band_; }
  bool
  inCreaseBand(const Eigen::Vector3d& p) const
  {
    return crease_band_ > 0.0 && mesh_->creases().distance(p, crease_band_) < crease_band_;
  }
  /** Where point \p i of the graph stands in the mesh and faces: its sample, not the fit; flat. */
  SurfaceFoot meshPlace(std::size_t i) const;
  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  ReferenceSurface(Surface::ConstPtr surface, ReferenceMesh::ConstPtr mesh);
  /** A gap's outline in its mean plane. */
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
  std::vector<Polyline> rims_; ///< closed: the first point comes again
  std::vector<std::unique_ptr<MoveIndex>> rim_index_;
  std::vector<Gap> gaps_;
  double rim_length_ = 0.0, rim_strip_ = 0.0;
  std::vector<std::string> warnings_;
};

/** Statements about what the scan cannot show: the scallop height and the chord error asked for that lie
 * below its noise or below the noise of the surface fitted to it; of a mesh, below three times the latter. 0: nothing was asked
 * for. */
std::vector<std::string>
noiseWarnings(const ReferenceSurface& reference, double scallop_height, double chord_error);

} // namespace pcl_spiral
