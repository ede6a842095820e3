// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which points of a scan are to be cut: a crop, and places that the cutter keeps out of.
 */
#pragma once

#include <pcl_spiral/cleaning/impl/status_filter.h>
#include <pcl_spiral/core/prism.h>

#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace pcl_spiral {

class PointBlocks;

/** What PartRegion left out: points. */
struct RegionReport {
  std::size_t cropped = 0;   ///< outside the crop
  std::size_t kept_out = 0;  ///< inside a keep-out
  std::size_t too_close = 0; ///< outside, but the ball is too close to a keep-out, or its shank to an obstacle
};

/** \deprecated Use RegionReport. */
using RegionFigures [[deprecated("use RegionReport")]] = RegionReport;

/** Keeps the points of a scan that are to be cut: those inside the crop at which a ball can touch the surface without entering a
 *  keep-out, its shank without touching what stands there. A keep-out has no end along its axis, so the ball is also out of the space
 *  over it. Points that are not finite are left out. Lengths in mm.
 *  \code
 *  PartRegion<pcl::PointXYZ> region;
 *  region.setInputCloud(scan);
 *  region.setInputNormals(normals);      // of the surface, out of the material
 *  region.addKeepOut(Prism(corners, Eigen::Vector3d::UnitZ()));
 *  region.setToolRadius(10.0);
 *  const pcl::IndicesPtr part(new pcl::Indices);
 *  region.filter(*part);
 *  if (!region.getStatus().ok()) ...     // and the output is empty
 *  Surroundings around;
 *  around.keep_outs = region.getKeepOuts();
 *  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
 *  spiral.setInputCloud(scan);
 *  spiral.setIndices(part);              // what is left out of the scan is an obstacle
 *  spiral.setSurroundings(around);
 *  \endcode
 *  A cloud of the points kept does not carry the keep-outs on: a path over it would cross the hole that they leave. So filter with a cloud
 *  as output is refused if there is a keep-out.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class PartRegion : public StatusFilter<PointT> {
public:
  using Ptr = pcl::shared_ptr<PartRegion>;                             ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const PartRegion>;                  ///< A shared pointer to a constant one.
  using NormalsConstPtr = typename pcl::PointCloud<PointNT>::ConstPtr; ///< Normals of the input, shared.

  /** \p extract_removed_indices: if true, getRemovedIndices has the points left out. */
  explicit PartRegion(bool extract_removed_indices = false) : StatusFilter<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "PartRegion";
  }

  /** Only points in this box are part of the scan. */
  void setCropBox(const Eigen::AlignedBox3d& box) { crop_box_ = box; }
  const std::optional<Eigen::AlignedBox3d>& getCropBox() const { return crop_box_; } ///< The value of setCropBox.

  /** Only points in this prism are part of the scan. */
  void setCrop(const Prism& prism) { crop_ = prism; }
  const std::optional<Prism>& getCrop() const { return crop_; } ///< The value of setCrop.

  /** The ball must not enter this prism. May be called several times. */
  void addKeepOut(const Prism& prism) { keep_outs_.push_back(prism); }
  const std::vector<Prism>& getKeepOuts() const { return keep_outs_; } ///< All prisms of addKeepOut.

  /** Radius of the ball; 0, the default: only points inside a keep-out are left out. */
  void setToolRadius(double radius) { tool_radius_ = radius; }
  double getToolRadius() const { return tool_radius_; } ///< The value of setToolRadius.

  /** Least distance between the ball and a keep-out; 0 by default. */
  void setMargin(double distance) { margin_ = distance; }
  double getMargin() const { return margin_; } ///< The value of setMargin.

  /** Shank above the ball, as wide as the ball: its length, mm, and how far the tool axis may lean from the normal in any direction,
   *  degrees, below 90. Length 0, the default: no shank. */
  void setShank(double length, double lean)
  {
    shank_length_ = length;
    lean_ = lean;
  }
  double getShankLength() const { return shank_length_; } ///< The length of setShank.
  double getLean() const { return lean_; }                ///< The lean of setShank.

  /** Points that the shank must not touch where normals are known, as those of a clamp in a keep-out: the scanner sees the top of a
   *  clamp, and the shank meets it. */
  void setObstacles(const std::vector<Eigen::Vector3f>& points);

  /** Normals of the input, one per point, out of the material: the ball that touches the surface at a point has its centre one
   *  radius along them. Where the normal is zero, or without normals, its centre may be anywhere within one radius. */
  void setInputNormals(const NormalsConstPtr& normals) { normals_ = normals; }
  NormalsConstPtr getInputNormals() const { return normals_; } ///< The value of setInputNormals.

  const RegionReport& getReport() const { return figures_; }                                     ///< Figures of the last call of filter.
  [[deprecated("use getReport")]] const RegionReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.

protected:
  void applyFilter(pcl::PointCloud<PointT>& output) override; ///< What pcl::Filter calls.
  using StatusFilter<PointT>::applyFilter;
  void forgetResult() override { figures_ = RegionReport(); } ///< Clears the figures.
  /** Fails on a polygon with a fault, a negative length, or a wrong number of normals. */
  Status choose(pcl::Indices& kept, pcl::Indices& removed) override;

private:
  Status check() const;
  bool keeps(std::size_t i);
  bool shankMeets(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) const;

  std::optional<Eigen::AlignedBox3d> crop_box_;
  std::optional<Prism> crop_;
  std::vector<Prism> keep_outs_;
  double tool_radius_ = 0.0;
  double margin_ = 0.0;
  double shank_length_ = 0.0, lean_ = 0.0;
  std::shared_ptr<const PointBlocks> obstacles_; ///< null: none
  NormalsConstPtr normals_;
  bool into_cloud_ = false; ///< filter with a cloud as output is running
  RegionReport figures_;
};

} // namespace pcl_spiral

#include <pcl_spiral/cleaning/impl/part_region.hpp>

namespace pcl_spiral {
extern template class PartRegion<pcl::PointXYZ>;
extern template class PartRegion<pcl::PointXYZRGB>;
extern template class PartRegion<pcl::PointXYZI>;
extern template class PartRegion<pcl::PointNormal>;
} // namespace pcl_spiral
