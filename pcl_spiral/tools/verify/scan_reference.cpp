// SPDX-License-Identifier: BSD-3-Clause
#include "scan_reference.h"

#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/surface/scanned_surface.h>

using namespace pcl_spiral;

std::shared_ptr<const ReferenceSurface>
scanReference(const VerifyJob& job, const JudgedPart& part)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(part.cloud);
  scanned.setStrict(false); // a rough reference is accepted, with a warning
  scanned.setClusterHandling(job.part.clusters);
  scanned.setFlipNormals(job.settings.flip_normals);
  setSide(part.side, scanned);
  if (part.chosen.part_at)
    scanned.setPartAt(*part.chosen.part_at);
  scanned.setNumberOfThreads(job.settings.threads);
  ProgressBar bar(job.quiet);
  scanned.setProgressCallback([&bar](double share, const std::string&) { return bar.update(share, "reference"); });
  Surface::ConstPtr surface;
  scanned.compute(surface);
  bar.clear();
  if (cancelled())
    throw Cancelled();
  if (!scanned.getStatus().ok())
    throw FileError(job.scan, scanned.getStatus().diagnostic());
  return std::make_shared<ReferenceSurface>(surface);
}
