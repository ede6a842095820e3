// SPDX-License-Identifier: BSD-3-Clause
#include "case_series.h"
#include "method_name.h"
#include "path_match.h"

#include "support/sampling.h"

#include <cmath>
#include <sstream>

namespace pcl_spiral::acceptance {

namespace {

constexpr unsigned int longest_case = 200; ///< s

/** A run of the planner on a case. */
struct Made {
  Path path;
  Status status;
};

Made
made(const Cloud::ConstPtr& cloud, const SpiralSettings& settings)
{
  Generator generator;
  generator.setInputCloud(cloud);
  generator.setSettings(settings);
  Made result;
  generator.compute(result.path);
  result.status = generator.getStatus();
  return result;
}

Cloud::Ptr
mapped(const Cloud& cloud, const Eigen::Affine3d& map)
{
  const Cloud::Ptr result(new Cloud(cloud));
  for (pcl::PointXYZ& p : *result)
    p.getVector3fMap() = (map * p.getVector3fMap().cast<double>()).cast<float>();
  return result;
}

/** The settings for the part under a similarity: lengths are scaled with it; on a mirrored part the sense is opposite and the
 *  axis is tilted to the other side of the feed. */
SpiralSettings
mapped(const SpiralSettings& settings, const Eigen::Affine3d& map)
{
  const double determinant = map.linear().determinant(), scale = std::cbrt(std::abs(determinant));
  SpiralSettings s = settings;
  for (double* length :
       {&s.tool_radius, &s.scallop_height, &s.chord_error, &s.max_step, &s.axis_smoothing, &s.thinning, &s.feed, &s.acceleration})
    *length *= scale;
  s.max_axis_rate /= scale;
  for (std::optional<Eigen::Vector3d>* place : {&s.centre, &s.start_point, &s.view_point})
    if (*place)
      **place = map * **place;
  if (determinant >= 0.0)
    return s;
  s.tilt_angle = -s.tilt_angle; // about the feed, to its right
  s.sense = s.sense == SpiralSense::Clockwise ? SpiralSense::CounterClockwise : SpiralSense::Clockwise;
  return s;
}

Cloud::Ptr
reordered(const Cloud& cloud, std::uint64_t seed)
{
  const Cloud::Ptr result(new Cloud);
  for (const std::size_t i : test::shuffled(cloud.size(), seed))
    result->push_back(cloud[i]);
  return result;
}

/** A part, moved: \p exact if its coordinates in single precision are moved without rounding. With new rounding a scan
 *  is slightly different, and sometimes a point or a corner is decided differently. */
struct Motion {
  std::string name;
  Eigen::Affine3d map;
  bool exact;
};

/** Faults of \p other, made on the moved part; empty if there are none. */
std::string
difference(const Motion& motion, const Made& first, const Made& other, double spacing)
{
  const double tolerance = motion.exact ? 0.02 : 0.1; // spacings; axes a spacing of path apart may differ by ten degrees
  std::ostringstream text;
  if (first.status.code() != other.status.code() || reasonOf(first.status.message()) != reasonOf(other.status.message()))
    text << motion.name << ": " << (other.status.ok() ? "a path" : other.status.message()) << " instead of "
         << (first.status.ok() ? "a path" : first.status.message()) << "; ";
  else if (first.status.ok()) {
    const PathMatch m = matched(acceptance::mapped(other.path, motion.map.inverse()), first.path);
    const Eigen::Array4d off = Eigen::Array4d(m.off.value, m.missed.value, m.start, m.end) / spacing;
    if (!(off <= tolerance).all() || !(m.axis <= 10.0 * tolerance))
      text << motion.name << ": off by " << off.transpose() << " spacings, axis by " << m.axis << " degrees; ";
  }
  return text.str();
}

/** Motions that do not change the path on the part. At constant scallop height other rounding may change the links between
 *  loops: so only a scale without rounding is tested there. */
std::vector<Motion>
motions(const Eigen::Affine3d& moved, SpiralMethod method)
{
  const Eigen::Affine3d same = Eigen::Affine3d::Identity();
  std::vector<Motion> all{{"a 64th", same * Eigen::Scaling(1.0 / 64), true}};
  if (method != SpiralMethod::Radial)
    return all;
  Eigen::Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  all.push_back({"turned by 90 degrees", Eigen::Affine3d(quarter), true});
  all.push_back({"mirrored", same * Eigen::Scaling(-1.0, 1.0, 1.0), true});
  all.push_back({"moved", moved, false});
  all.push_back({"mirrored and moved", moved * Eigen::Scaling(1.0, 1.0, -1.0), false});
  all.push_back({"forty times", moved * Eigen::Scaling(40.0), false});
  return all;
}

Outcome
propertiesOf(const RandomCase& random, SpiralMethod method)
{
  SpiralSettings settings = settingsOf(random, method);
  settings.thinning = 0.0;   // voxels are parallel to the axes
  if (!settings.start_point) // on round parts several rim points are the farthest
    settings.start_point = random.motion * random.surface->outlines().front().front();
  const Made first = made(random.cloud, settings);
  std::string faults;
  for (const int threads : {2, 3}) {
    SpiralSettings shared = settings;
    shared.threads = threads;
    const Made again = made(random.cloud, shared);
    if (again.status.message() != first.status.message() || !sameBytes(first.path, again.path))
      faults += std::to_string(threads) + " threads: other bytes; ";
  }
  const std::uint64_t seed = random.cloud->size();
  const Eigen::Affine3d same = Eigen::Affine3d::Identity(), moved(test::randomMotion(seed, 50.0 * random.spacing));
  faults += difference({"shuffled", same, true}, first, made(reordered(*random.cloud, seed), settings), random.spacing);
  for (const Motion& motion : motions(moved, method))
    faults += difference(motion, first, made(mapped(*random.cloud, motion.map), mapped(settings, motion.map)), random.spacing);
  return {first.status.ok() ? "path" : reasonOf(first.status.message()), faults};
}

} // namespace

int
judgeProperties(const Options& options)
{
  if (!isMethod(options.method))
    return 2;
  return judgeSeries("properties", options, longest_case,
                     [&options](const RandomCase& random) { return propertiesOf(random, *methodNamed(options.method)); });
}

} // namespace pcl_spiral::acceptance
