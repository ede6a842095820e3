// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input of the stages, made once for each size and before the clock runs.
 */
#pragma once

#include "clouds.h"

#include "support/pcl_pair.h"

#include "geodesic/distance_field.h"
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>

#include <map>
#include <memory>
#include <optional>

namespace pcl_spiral::benchmarks {

enum class FileOrder { Random, Sorted };

/** A cloud of one size and the results of stages that later stages need, each made when first used.
 *  86k points are the free-form part, every other number is the dome. */
class StageInput {
public:
  explicit StageInput(std::size_t points);

  const Points& points(FileOrder order = FileOrder::Random);
  const Cloud::ConstPtr& cloud(FileOrder order);
  const test::NormalCloud::ConstPtr& normals(FileOrder order);
  const test::Tree::Ptr& tree(FileOrder order);

  const SurfaceGraph& graph();
  const MlsSurface& surface();
  Eigen::Vector3d centre() const;
  const DistanceField& field();
  const Polyline& rim();
  /** Lines from the centre to places evenly along the rim, traced down the field. */
  const std::vector<GeodesicLine>& traces();
  /** As many path points as cloud points, in turns as far apart as the points of a turn. */
  const Polyline& spiral();
  const std::vector<SurfaceFoot>& spiralFeet();
  const pcl::PointCloud<ToolpathPoint>& path();

private:
  CloudPlan plan_;
  std::map<FileOrder, Points> points_;
  std::map<FileOrder, Cloud::ConstPtr> clouds_;
  std::map<FileOrder, test::NormalCloud::ConstPtr> normals_;
  std::map<FileOrder, test::Tree::Ptr> trees_;
  std::optional<SurfaceGraph> graph_;
  std::optional<MlsSurface> surface_;
  std::optional<DistanceField> field_;
  Polyline rim_, spiral_;
  std::vector<GeodesicLine> traces_;
  std::vector<SurfaceFoot> feet_;
  pcl::PointCloud<ToolpathPoint> path_;
};

/** The input of that size. Only one size is kept: another size replaces it. */
StageInput& inputOf(std::size_t points);

/** Throws the error of a stage: its time would have no meaning. */
void require(const Status& status);

} // namespace pcl_spiral::benchmarks
