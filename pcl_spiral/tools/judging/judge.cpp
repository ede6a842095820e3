// SPDX-License-Identifier: BSD-3-Clause
#include "judge.h"

#include "verify/path_ridges.h"
#include <pcl_spiral/verify/material_removal.h>

#include <chrono>

using namespace pcl_spiral;

namespace {

template <typename Judge>
void
prepare(Judge& judge, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
        const JudgeSettings& settings)
{
  if (settings.mesh) {
    judge.setInputMesh(settings.mesh);
    judge.setSampleSpacing(settings.sample_spacing);
  }
  else
    judge.setInputCloud(scan);
  if (settings.surface)
    judge.setInputSurface(settings.surface);
  judge.setInputToolpath(path);
  judge.setChordError(settings.chord_error);
  judge.setNumberOfThreads(settings.threads);
  if (settings.surface || settings.mesh)
    return; // oriented already
  if (settings.part_at)
    judge.setPartAt(*settings.part_at);
  judge.setClusterHandling(settings.clusters);
  judge.setFlipNormals(settings.flip_normals);
  setSide(settings.side, judge);
}

std::vector<float>
intensities(const pcl::PointCloud<pcl::PointXYZI>& cloud)
{
  std::vector<float> values;
  for (const pcl::PointXYZI& point : cloud)
    values.push_back(point.intensity);
  return values;
}

/** The points that heights belong to: those of the scan, or the samples of the mesh. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
judgedPoints(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const ReferenceSurface& reference)
{
  if (!reference.mesh())
    return scan;
  const auto samples = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const pcl::PointNormal& sample : *reference.mesh()->samples())
    samples->emplace_back(sample.x, sample.y, sample.z);
  return samples;
}

} // namespace

Status
judgeDeviation(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
               const JudgeSettings& settings, const ProgressCallback& progress, std::shared_ptr<const ReferenceSurface>& reference,
               Verification& verification, Heights& heights)
{
  pcl::PointCloud<pcl::PointXYZI> values;
  DeviationEstimation<pcl::PointXYZ> deviation;
  prepare(deviation, scan, path, settings);
  deviation.setReferenceSurface(reference);
  deviation.setProgressCallback([&](double share, const std::string&) { return progress(share, "deviation"); });
  deviation.compute(values);
  if (deviation.getStatus().ok()) {
    reference = deviation.getReferenceSurface();
    heights.points = judgedPoints(scan, *reference);
    heights.deviation = intensities(values);
    verification.deviation = deviation.getFigures();
    verification.side = reference->scanned().side();
  }
  return deviation.getStatus();
}

Status
judgePath(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
          const JudgeSettings& settings, const ProgressCallback& progress, std::shared_ptr<const ReferenceSurface>& reference,
          Verification& verification, Heights& heights)
{
  const auto start = std::chrono::steady_clock::now();
  const Status status = judgeDeviation(
      scan, path, settings, [&](double share, const std::string& stage) { return progress(0.3 * share, stage); }, reference, verification,
      heights);
  if (!status.ok())
    return status;
  pcl::PointCloud<pcl::PointXYZI> values;
  MaterialRemoval<pcl::PointXYZ> removal;
  prepare(removal, scan, path, settings);
  removal.setReferenceSurface(reference);
  removal.setCutter(settings.cutter);
  removal.setInputTips(settings.tips);
  removal.setScallopHeight(settings.scallop_height);
  removal.setProgressCallback([&](double share, const std::string&) { return progress(0.3 + 0.7 * share, "removed material"); });
  removal.compute(values);
  heights.stock = intensities(values);
  heights.ridges = removal.getRidgeHeights();
  verification.removal = removal.getFigures();
  if (removal.getStatus().ok())
    heights.scallop = ridgesAlong(*path, values, heights.ridges);
  verification.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return removal.getStatus();
}
