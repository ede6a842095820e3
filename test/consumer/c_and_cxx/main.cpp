// Uses the classes with a point type of its own, from a project with C in it.
#include <pcl_spiral/search/elliptic_gabriel_graph.h>

#include <pcl/point_cloud.h>
#include <pcl/register_point_struct.h>

#include <cmath>
#include <iostream>

/** A point as some scanner gives it. */
struct EIGEN_ALIGN16 ScannerPoint {
  PCL_ADD_POINT4D;
  float confidence;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(ScannerPoint, (float, x, x)(float, y, y)(float, z, z)(float, confidence, confidence))

extern "C" double
metres_to_millimetres(double metres);

/** A dome of 0.08 m radius, its points on a sunflower. */
pcl::PointCloud<ScannerPoint>::Ptr
scanOfDome(int count)
{
  const double radius = metres_to_millimetres(0.08);
  pcl::PointCloud<ScannerPoint>::Ptr cloud(new pcl::PointCloud<ScannerPoint>);
  for (int i = 0; i < count; ++i) {
    const double r = 0.6 * radius * std::sqrt((i + 0.5) / count), angle = 2.399963229728653 * i;
    ScannerPoint point;
    point.getVector3fMap() =
        Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), std::sqrt(radius * radius - r * r)).cast<float>();
    point.confidence = 1.0f;
    cloud->push_back(point);
  }
  return cloud;
}

int
main()
{
  pcl_spiral::EllipticGabrielGraph<ScannerPoint> egg;
  egg.setInputCloud(scanOfDome(5000));
  pcl_spiral::NeighbourLists graph;
  egg.compute(graph);
  if (!egg.getStatus().ok()) {
    std::cerr << egg.getStatus().message() << '\n';
    return 1;
  }
  const double degree = 2.0 * graph.edgeCount() / graph.size();
  std::cout << "c_and_cxx: mean degree " << degree << " on points of our own\n";
  return degree > 4 && degree < 8 ? 0 : 1;
}
