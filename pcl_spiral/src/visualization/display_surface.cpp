#include "display_surface.h"

#include <pcl_spiral/search/surface_graph.h>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_points = 200000; ///< more than this a picture of 1600 x 1200 does not show
constexpr double margin = 0.03;             ///< of the part's size, about the box
constexpr double least_mean_normal = 0.25;  ///< a shorter mean of unit normals tells no side

void
measurePath(const PictureScene& scene, DisplaySurface& surface)
{
  surface.low.setConstant(std::numeric_limits<double>::max());
  surface.high = -surface.low;
  surface.outward.setZero();
  const auto extend = [&surface](const Eigen::Vector3d& p) {
    surface.low = surface.low.cwiseMin(p);
    surface.high = surface.high.cwiseMax(p);
  };
  double weight = 0.0;
  for (std::size_t i = 0; i < scene.path->size(); ++i) {
    const ToolpathPoint& point = (*scene.path)[i];
    extend(point.getVector3fMap().cast<double>());
    const double step = i > 0 ? point.arc_length - (*scene.path)[i - 1].arc_length : 0.0;
    surface.outward += step * point.getNormalVector3fMap().cast<double>();
    weight += step;
  }
  for (const BoundaryLoop& loop : scene.report.loops)
    for (const Eigen::Vector3d& p : loop.points)
      extend(p);
  const bool clear = weight > 0.0 && surface.outward.norm() > least_mean_normal * weight;
  surface.outward = clear ? surface.outward.normalized() : Eigen::Vector3d::Zero().eval();
}

/** Finite points inside the box; a fixed share of them, spread evenly over the file, where there are too
 * many. */
std::vector<Eigen::Vector3f>
shownPoints(const PictureScene& scene, const DisplaySurface& surface)
{
  const Eigen::Vector3d extra = Eigen::Vector3d::Constant(margin * (surface.high - surface.low).norm());
  const Eigen::Vector3f low = (surface.low - extra).cast<float>(),
                        high = (surface.high + extra).cast<float>();
  std::vector<Eigen::Vector3f> points;
  const double share =
      std::min(1.0, static_cast<double>(most_points) / static_cast<double>(scene.cloud->size()));
  for (std::size_t i = 0; i < scene.cloud->size(); ++i) {
    // a low-discrepancy sequence: every stretch of the file keeps the same share of its points
    const double fraction = std::fmod(0.6180339887498949 * static_cast<double>(i), 1.0);
    const Eigen::Vector3f p = (*scene.cloud)[i].getVector3fMap();
    if (fraction < share && p.allFinite() && (p.array() >= low.array()).all() &&
        (p.array() <= high.array()).all())
      points.push_back(p);
  }
  return points;
}

/** Triangulate what is shown. */
DisplaySurface
displaySurface(const PictureScene& scene)
{
  DisplaySurface surface;
  measurePath(scene, surface);
  SurfaceGraph graph;
  SurfaceGraphOptions options;
  options.view_point = scene.settings.view_point;
  options.flip_normals = scene.settings.flip_normals;
  graph.build(shownPoints(scene, surface),
              options); // where it fails the surface stays empty; the path is drawn alone

  const Eigen::Vector3d up = surface.outward.isZero() ? Eigen::Vector3d::UnitZ() : surface.outward;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals, heights;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  heights->SetName("Height");
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Eigen::Vector3d p = graph.position(i);
    points->InsertNextPoint(p.data());
    normals->InsertNextTuple(graph.normal(i).eval().data());
    heights->InsertNextValue(static_cast<float>(p.dot(up)));
  }
  vtkNew<vtkCellArray> triangles;
  for (std::size_t t = 0; t < graph.triangulation().triangleCount(); ++t) {
    const Triangulation::Triangle& corners = graph.triangulation().triangle(t);
    const vtkIdType ids[3] = {corners[0], corners[1], corners[2]};
    triangles->InsertNextCell(3, ids);
  }
  surface.spacing = graph.size() > 0 ? graph.spacing() : 0.0;
  surface.mesh = vtkSmartPointer<vtkPolyData>::New();
  surface.mesh->SetPoints(points);
  surface.mesh->SetPolys(triangles);
  surface.mesh->GetPointData()->SetNormals(normals);
  surface.mesh->GetPointData()->SetScalars(heights);
  return surface;
}

} // namespace

SpiralPictures::SpiralPictures(PictureScene scene)
    : scene_(std::move(scene)), surface_(std::make_unique<DisplaySurface>(displaySurface(scene_)))
{
}

SpiralPictures::~SpiralPictures() = default;

} // namespace pcl_spiral
