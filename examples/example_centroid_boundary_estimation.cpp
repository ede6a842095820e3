// SPDX-License-Identifier: BSD-3-Clause
// Boundary points of a square with a round hole, by the three criteria.
#include <pcl_spiral/features/centroid_boundary_estimation.h>

#include <cmath>
#include <cstdio>
#include <random>

int
main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(0.0f, 100.0f);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  while (cloud->size() < 10000) {
    const pcl::PointXYZ p(side(random), side(random), 0.0f);
    if (std::hypot(p.x - 50.0f, p.y - 50.0f) > 15.0f)
      cloud->push_back(p);
  }
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>(10000, 1, pcl::Normal(0, 0, 1)));

  pcl_spiral::CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setKSearch(32);
  const struct {
    const char* name;
    pcl_spiral::BoundaryCriterion criterion;
  } criteria[] = {{"centroid", pcl_spiral::BoundaryCriterion::Centroid},
                  {"largest gap", pcl_spiral::BoundaryCriterion::LargestGap},
                  {"combined", pcl_spiral::BoundaryCriterion::Combined}};
  for (const auto& c : criteria) {
    estimation.setCriterion(c.criterion);
    pcl::PointCloud<pcl::Boundary> boundary;
    estimation.compute(boundary);
    if (!estimation.getStatus().ok())
      return 1;
    int marked = 0, far = 0;
    for (std::size_t i = 0; i < boundary.size(); ++i)
      if (boundary[i].boundary_point) {
        const pcl::PointXYZ& p = (*cloud)[i];
        const float rim = std::min(std::min(p.x, 100 - p.x), std::min(p.y, 100 - p.y));
        ++marked;
        far += std::min(rim, std::hypot(p.x - 50, p.y - 50) - 15) > 3.0f;
      }
    std::printf("%-12s %4d boundary points, %d of them more than 3 mm from an outline\n", c.name, marked, far);
  }
  std::printf("score of the first point: %.4f\n", estimation.getScores()[0]);
  return 0;
}
