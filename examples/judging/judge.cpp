#include "judge.h"

#include <pcl_spiral/verify/material_removal.h>

using namespace pcl_spiral;

namespace {

template <typename Judge>
void
prepare(Judge& judge, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan,
        const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings)
{
  judge.setInputCloud(scan);
  judge.setInputToolpath(path);
  judge.setChordError(settings.chord_error);
  judge.setFlipNormals(settings.flip_normals);
  judge.setNumberOfThreads(settings.threads);
  if (settings.view_point)
    judge.setViewPoint(*settings.view_point);
}

} // namespace

Status
judgePath(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
          const JudgeSettings& settings, const ProgressCallback& progress,
          std::shared_ptr<const ScannedReference>& surface, Verification& verification)
{
  pcl::PointCloud<pcl::PointXYZI> heights;
  DeviationEstimation<pcl::PointXYZ> deviation;
  prepare(deviation, scan, path, settings);
  deviation.setReferenceSurface(surface);
  deviation.setProgressCallback(
      [&](double share, const std::string&) { return progress(0.3 * share, "deviation"); });
  deviation.compute(heights);
  if (!deviation.getStatus().ok())
    return deviation.getStatus();
  surface = deviation.getReferenceSurface();
  verification.deviation = deviation.getFigures();

  MaterialRemoval<pcl::PointXYZ> removal;
  prepare(removal, scan, path, settings);
  removal.setReferenceSurface(surface);
  removal.setToolRadius(settings.tool_radius);
  removal.setScallopHeight(settings.scallop_height);
  removal.setProgressCallback(
      [&](double share, const std::string&) { return progress(0.3 + 0.7 * share, "removed material"); });
  removal.compute(heights);
  verification.removal = removal.getFigures();
  return removal.getStatus();
}
