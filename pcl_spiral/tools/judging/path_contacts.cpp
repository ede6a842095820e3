// SPDX-License-Identifier: BSD-3-Clause
#include "path_contacts.h"

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/verify/impl/cutter_contacts.h>

using namespace pcl_spiral;

void
findContacts(const ReferenceSurface& reference, const CutterShape& cutter, ToolpathFile& file)
{
  std::vector<CutterPlace> places;
  for (std::size_t i = 0; i < file.path.size(); ++i)
    places.push_back({file.tips[i], file.path[i].getAxisVector3fMap().cast<double>()});
  const std::vector<NearestContact> contacts = cutterContacts(reference, places, cutter);
  const std::vector<std::size_t> passes = passBegins(file.path);
  double length = 0.0;
  for (std::size_t i = 0; i < file.path.size(); ++i) {
    ToolpathPoint& point = file.path[i];
    if (contacts[i].valid)
      point.getVector3fMap() = contacts[i].position.cast<float>();
    point.getNormalVector3fMap() = contacts[i].valid ? Eigen::Vector3f(contacts[i].normal.cast<float>()) : point.getAxisVector3fMap();
    if (i > 0 && !beginsPass(passes, i))
      length += (point.getVector3fMap() - file.path[i - 1].getVector3fMap()).cast<double>().norm();
    point.arc_length = length;
  }
}
