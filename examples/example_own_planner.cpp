// SPDX-License-Identifier: BSD-3-Clause
// An own planner: straight rows along x, all cut one way, in place of a spiral. The generator does the rest.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <iostream>
#include <map>

using namespace pcl_spiral;

/** Rows so close that a flat part keeps the scallop height. Each is a pass, as is the rest of a row behind a hole. */
struct Rows : PathPlanner {
  Status plan(const PlannerInput& input, LinkedPath& path) const override
  {
    const double radius = input.settings.tool_radius, height = input.settings.scallop_height, step = input.surface.spacing();
    const double apart = 2.0 * std::sqrt(height * (2.0 * radius - height));
    std::map<int, std::map<double, double>> rows; // z over x of the points beside each row
    for (std::size_t i = 0; i < input.surface.size(); ++i) {
      const Eigen::Vector3d p = input.surface.position(i);
      for (int row = std::ceil((p.y() - step) / apart); row * apart < p.y() + step; ++row)
        rows[row][p.x()] = p.z();
    }
    for (const auto& [row, heights] : rows) {
      Eigen::Vector3d place(heights.begin()->first, row * apart, heights.begin()->second);
      for (bool begins = true; place.x() <= heights.rbegin()->first; place.x() += step) {
        SurfaceFoot foot = input.surface.fit().project(place);
        for (int round = 0; round < 3 && foot.valid; ++round) { // up or down to the surface
          place.z() += (foot.position - place).dot(foot.normal) / foot.normal.z();
          foot = input.surface.fit().project(place);
        }
        if (foot.valid && begins && !path.points.empty())
          path.passes.push_back(path.points.size());
        if (foot.valid)
          path.points.push_back(place);
        else
          place.z() = heights.lower_bound(place.x())->second; // on from the next point
        begins = !foot.valid;
      }
    }
    return Status::success();
  }
};

int
main()
try {
  SpiralToolpathGenerator<pcl::PointXYZ> rows;
  rows.setInputCloud(readCloud("scan.pcd").cloud);
  rows.setToolRadius(6.0); // mm
  rows.setScallopHeight(0.05);
  rows.setPlanner(std::make_shared<Rows>()); // and addModifier, for a class that changes the finished path
  pcl::PointCloud<ToolpathPoint> path;
  rows.compute(path); // prints why it fails
  writeToolpath("rows.csv", path, {rows.getToolRadius(), 1000.0});
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
}
