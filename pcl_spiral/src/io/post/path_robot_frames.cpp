// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>

#include <Eigen/Geometry>

namespace pcl_spiral {
namespace {

using Path = pcl::PointCloud<ToolpathPoint>;

/** Direction of travel at point \p i: to the next point at another place, at the end from the point before.
 */
Eigen::Vector3d
travelAt(const Path& path, std::size_t i)
{
  const auto place = [&path](std::size_t k) -> Eigen::Vector3d { return path[k].getVector3fMap().cast<double>(); };
  for (std::size_t k = i + 1; k < path.size(); ++k)
    if (place(k) != place(i))
      return place(k) - place(i);
  for (std::size_t k = i; k-- > 0;)
    if (place(k) != place(i))
      return place(i) - place(k);
  return Eigen::Vector3d::Zero();
}

/** Frame with z along the normal and x along the travel in the surface. */
Eigen::Quaterniond
frameAt(const Path& path, std::size_t i)
{
  const Eigen::Vector3d z = path[i].getNormalVector3fMap().cast<double>().normalized();
  Eigen::Vector3d travel = travelAt(path, i), x, y;
  travel -= travel.dot(z) * z;
  if (travel.norm() > 0.0)
    x = travel.normalized();
  else
    tangentFrame(z, x, y);
  Eigen::Matrix3d frame;
  frame << x, z.cross(x), z;
  Eigen::Quaterniond q(frame);
  if (q.w() < 0.0)
    q.coeffs() *= -1.0;
  return q.normalized();
}

} // namespace

void
writeRobotFrames(const std::string& file, const Path& path)
{
  if (path.empty())
    throw FileError(file, "not written: the path has no points");
  if (const std::size_t lifts = passBegins(path).size(); lifts > 0)
    throw FileError(file, "not written: the path has " + std::to_string(lifts + 1) +
                              " passes, and robot frames have no moves between them: make a "
                              "machine program, or cut both ways (setOneWay)");
  constexpr int decimals = 9; // a nanometre
  PostText out(file, decimals);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Quaterniond q = frameAt(path, i);
    const Eigen::Vector3d metres = path[i].getVector3fMap().cast<double>() / 1000.0;
    const std::pair<const char*, double> values[] = {{"x: ", metres.x()}, {", y: ", metres.y()}, {", z: ", metres.z()}, {", qw: ", q.w()},
                                                     {", qx: ", q.x()},   {", qy: ", q.y()},     {", qz: ", q.z()}};
    out.text(i == 0 ? "- - - - {" : "      - {");
    for (const auto& [name, value] : values) {
      out.text(name);
      out.number(value, decimals);
    }
    out.endLine("}\n");
  }
  out.close();
}

} // namespace pcl_spiral
