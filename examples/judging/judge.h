/** \file
 *  A toolpath judged by a scan or a mesh.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/io/verification_writer.h>
#include <pcl_spiral/verify/deviation_estimation.h>

/** How a path is judged. */
struct JudgeSettings {
  double tool_radius = 0.0, scallop_height = 0.0, chord_error = 0.0; ///< mm
  std::optional<Eigen::Vector3d> view_point;
  bool flip_normals = false;
  unsigned int threads = 0;
  pcl_spiral::Surface::ConstPtr surface; ///< of the scan, where one was made already; null: it is made
  pcl_spiral::SurfaceMesh::ConstPtr mesh; ///< judged by in place of a scan; null: none. Its faces tell the side
  double sample_spacing = 0.0;            ///< of the mesh, mm; 0: found
};

/** Values behind the figures, mm; see DeviationEstimation and MaterialRemoval. */
struct Heights {
  std::vector<float> deviation;     ///< one a path point
  std::vector<float> scallop; ///< one a path point: the ridge next to the nearest point of the scan; NaN: it has none
  std::vector<float> stock, ridges; ///< one a point of the places
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr places; ///< of stock: the scan, or the samples of the mesh that the path was judged by
};

/** How far \p path stands off \p scan, or off the mesh of \p settings, without a cutter: the figures of deviation alone. \p reference is
 * the fit to the scan, made where it is null. Fails as DeviationEstimation does. */
pcl_spiral::Status judgeDeviation(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan,
                                  const pcl::PointCloud<pcl_spiral::ToolpathPoint>::ConstPtr& path,
                                  const JudgeSettings& settings, const pcl_spiral::ProgressCallback& progress,
                                  std::shared_ptr<const pcl_spiral::ReferenceSurface>& reference,
                                  pcl_spiral::Verification& verification, Heights& heights);

/** The figures of \p path against \p scan, or the mesh of \p settings. \p reference is the fit to the scan, made where it is null and
 * kept for the next path. Fails as DeviationEstimation and MaterialRemoval do. */
pcl_spiral::Status judgePath(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan,
                             const pcl::PointCloud<pcl_spiral::ToolpathPoint>::ConstPtr& path,
                             const JudgeSettings& settings, const pcl_spiral::ProgressCallback& progress,
                             std::shared_ptr<const pcl_spiral::ReferenceSurface>& reference,
                             pcl_spiral::Verification& verification, Heights& heights);
