#include "scan_surface.h"
#include "terminal/setter_names.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/surface/scanned_surface.h>
#include <pcl_spiral/surface/stray_removal.h>

using namespace pcl_spiral;

void
require(const Job& job, const Status& status)
{
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (status.code() == StatusCode::InvalidArgument)
    throw UsageError(job.scan + ": " + inOptions(status.message()));
  if (!status.ok())
    throw FileError(job.scan, inOptions(status.message()));
}

void
leaveOutStrays(const Job& job, Result& result)
{
  StrayRemoval<pcl::PointXYZ> removal;
  removal.setNumberOfThreads(job.threads);
  removal.setInputCloud(result.scan.cloud);
  const pcl::PointCloud<pcl::PointXYZ>::Ptr kept(new pcl::PointCloud<pcl::PointXYZ>);
  removal.filter(*kept);
  require(job, removal.getStatus());
  const StrayFigures& f = removal.getFigures();
  if (f.strays > 0)
    result.warnings.push_back(textOf(f.strays, " of ", result.scan.cloud->size(),
                                     " points, off the scanned surface, were left out (--leave-out-strays), the largest "
                                     "group of them ", f.largest_group, " at ", placeText(f.largest_group_place),
                                     f.largest_group > 3 ? ": so many together are no false echo; see what stands there"
                                                         : ""));
  result.scan.cloud = kept;
}

Surface::ConstPtr
surfaceOf(const Job& job, ProgressBar& bar, const Result& result)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(result.scan.cloud);
  scanned.setStrict(false); // what is rough is driven on all the same, with a warning
  scanned.setQuiet(true);
  setSurface(job, scanned);
  scanned.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.3 * share, stage); });
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (scanned.getStatus().code() == StatusCode::Cancelled)
    throw Cancelled();
  return surface;
}
