// SPDX-License-Identifier: BSD-3-Clause
#include "display_surface.h"

#include <pcl_spiral/cleaning/impl/clean_graph.h>
#include <pcl_spiral/search/impl/point_selection.h>

#include <pcl/common/point_tests.h>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_points = 60000; ///< the part fills at most a million pixels: 4 pixels between points
constexpr double margin = 0.03;            ///< of the part's size, round the box
constexpr double hiding_clearance = 0.01;  ///< of the part's size
constexpr double least_mean_normal = 0.25; ///< a shorter mean of unit normals gives no side

void
extend(DisplaySurface& surface, const Eigen::Vector3d& p)
{
  surface.low = surface.low.cwiseMin(p);
  surface.high = surface.high.cwiseMax(p);
}

void
measurePath(const PictureScene& scene, DisplaySurface& surface)
{
  surface.low.setConstant(std::numeric_limits<double>::max());
  surface.high = -surface.low;
  surface.outward.setZero();
  double weight = 0.0;
  for (std::size_t i = 0; i < scene.path->size(); ++i) {
    const ToolpathPoint& point = (*scene.path)[i];
    extend(surface, point.getVector3fMap().cast<double>());
    const double step = i > 0 ? point.arc_length - (*scene.path)[i - 1].arc_length : 0.0;
    surface.outward += step * point.getNormalVector3fMap().cast<double>();
    weight += step;
  }
  for (const BoundaryLoop& loop : scene.report.loops)
    for (const Eigen::Vector3d& p : loop.points)
      extend(surface, p);
  const bool clear = weight > 0.0 && surface.outward.norm() > least_mean_normal * weight;
  surface.outward = clear ? surface.outward.normalized() : Eigen::Vector3d::Zero().eval();
}

/** Without a path the whole scan is shown. */
void
measureScan(const PictureScene& scene, DisplaySurface& surface)
{
  for (const pcl::PointXYZ& point : *scene.cloud)
    if (pcl::isFinite(point))
      extend(surface, point.getVector3fMap().cast<double>());
}

/** Limits the scan to a box round the part, larger by \p beyond of the box's size. */
void
measurePart(const PictureScene& scene, double beyond, DisplaySurface& surface)
{
  if (scene.mesh) {
    for (std::size_t t = 0; t < scene.mesh->faceCount(); ++t)
      for (const std::uint32_t v : scene.mesh->triangles().triangle(t))
        extend(surface, scene.mesh->position(v));
    return;
  }
  const Eigen::Array3d reach = Eigen::Array3d::Constant(beyond * (surface.high - surface.low).norm());
  const Eigen::Array3d low = surface.low.array() - reach, high = surface.high.array() + reach;
  if (!(beyond > 0.0))
    return;
  for (const pcl::PointXYZ& point : *scene.cloud)
    if (const Eigen::Vector3d p = point.getVector3fMap().cast<double>(); (p.array() >= low).all() && (p.array() <= high).all())
      extend(surface, p);
}

/** Finite points inside the box. If there are too many: the points of the loops, and a fixed share of the
 * others, spread evenly over the file. */
std::vector<Eigen::Vector3f>
shownPoints(const PictureScene& scene, const DisplaySurface& surface)
{
  const Eigen::Vector3d extra = Eigen::Vector3d::Constant(margin * (surface.high - surface.low).norm());
  const Eigen::Vector3f low = (surface.low - extra).cast<float>(), high = (surface.high + extra).cast<float>();
  std::vector<bool> on_loop(scene.cloud->size(), false);
  for (const BoundaryLoop& loop : scene.report.loops)
    for (const pcl::index_t i : loop.indices)
      if (i >= 0 && static_cast<std::size_t>(i) < on_loop.size())
        on_loop[static_cast<std::size_t>(i)] = true;
  std::vector<Eigen::Vector3f> points;
  const double share = std::min(1.0, static_cast<double>(most_points) / static_cast<double>(scene.cloud->size()));
  for (std::size_t i = 0; i < scene.cloud->size(); ++i) {
    // a low-discrepancy sequence: every part of the file keeps the same share of its points
    const double fraction = std::fmod(0.6180339887498949 * static_cast<double>(i), 1.0);
    const Eigen::Vector3f p = (*scene.cloud)[i].getVector3fMap();
    if ((fraction < share || on_loop[i]) && p.allFinite() && (p.array() >= low.array()).all() && (p.array() <= high.array()).all())
      points.push_back(p);
  }
  return points;
}

/** A graph of the surface, without the outliers that were left out for the path. */
SurfaceGraph
graphOf(std::vector<Eigen::Vector3f> points, const SpiralSettings& settings)
{
  if (settings.outlier_neighbours > 0) {
    std::vector<Eigen::Vector3f> kept;
    for (const std::uint32_t i : statisticalInliers(points, settings.outlier_neighbours, settings.outlier_deviations))
      kept.push_back(points[i]);
    points = std::move(kept);
  }
  SurfaceGraphOptions options;
  options.view_point = settings.view_point;
  options.flip_normals = settings.flip_normals;
  SurfaceGraph graph;
  GraphSource source;
  // if it fails, the surface stays empty and only the path is drawn
  (void)buildCleanGraph(std::move(points), options, graph, source);
  return graph;
}

/** The points of the scan alone: without a path nothing says which of them are a part. */
void
addPoints(const PictureScene& scene, const Eigen::Vector3d& up, DisplaySurface& surface)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  for (const Eigen::Vector3f& p : shownPoints(scene, surface)) {
    points->InsertNextPoint(p.x(), p.y(), p.z());
    heights->InsertNextValue(static_cast<float>(p.cast<double>().dot(up)));
  }
  const Eigen::Vector3d size = surface.high - surface.low;
  surface.spacing = std::sqrt(size.x() * size.y() / static_cast<double>(std::max<vtkIdType>(1, points->GetNumberOfPoints())));
  surface.mesh = vtkSmartPointer<vtkPolyData>::New();
  surface.mesh->SetPoints(points);
  surface.mesh->GetPointData()->SetScalars(heights);
  vtkNew<vtkCellArray> dots;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    dots->InsertNextCell(1, &i);
  surface.mesh->SetVerts(dots);
}

/** Triangles over the scan. */
void
addScan(const PictureScene& scene, const Eigen::Vector3d& up, DisplaySurface& surface)
{
  const SurfaceGraph graph = graphOf(shownPoints(scene, surface), scene.settings);
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
}

} // namespace

DisplaySurface
displaySurface(const PictureScene& scene, double beyond)
{
  DisplaySurface surface;
  measurePath(scene, surface);
  if (scene.path->empty())
    measureScan(scene, surface);
  measurePart(scene, beyond, surface);
  const Eigen::Vector3d up = surface.outward.isZero() ? Eigen::Vector3d::UnitZ() : surface.outward;
  surface.of_mesh = scene.mesh != nullptr;
  if (surface.of_mesh) {
    surface.mesh = meshTriangles(*scene.mesh, (surface.high - surface.low).norm(), up);
    surface.spacing = scene.report.spacing;
  }
  else if (scene.path->empty())
    addPoints(scene, up, surface);
  else
    addScan(scene, up, surface);
  return surface;
}

double
clearance(const DisplaySurface& surface)
{
  return std::max(surface.of_mesh ? 0.0 : 0.7 * surface.spacing, 0.004 * (surface.high - surface.low).norm());
}

vtkSmartPointer<vtkPolyData>
surfaceNear(const DisplaySurface& surface, const Eigen::Vector3d& centre, double reach)
{
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface.mesh->GetNumberOfPolys(); ++t) {
    surface.mesh->GetPolys()->GetCellAtId(t, corners);
    Eigen::AlignedBox3d box;
    for (vtkIdType i = 0; i < 3; ++i)
      box.extend(Eigen::Map<const Eigen::Vector3d>(surface.mesh->GetPoint(corners->GetId(i))));
    if (((box.min() - centre).array() < reach).all() && ((centre - box.max()).array() < reach).all())
      triangles->InsertNextCell(corners);
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(surface.mesh->GetPoints());
  part->SetPolys(triangles);
  part->GetPointData()->SetNormals(surface.mesh->GetPointData()->GetNormals());
  return part;
}

bool
hides(const DisplaySurface& surface, const Eigen::Vector3d& place, const Eigen::Vector3d& towards)
{
  const Eigen::Vector3d from = place + hiding_clearance * (surface.high - surface.low).norm() * towards;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface.mesh->GetNumberOfPolys(); ++t) {
    surface.mesh->GetPolys()->GetCellAtId(t, corners);
    std::array<Eigen::Vector3d, 3> p; // from the start of the ray
    for (int i = 0; i < 3; ++i)
      p[i] = Eigen::Map<const Eigen::Vector3d>(surface.mesh->GetPoint(corners->GetId(i))) - from;
    const double a = towards.dot(p[1].cross(p[2])), b = towards.dot(p[2].cross(p[0])),
                 c = towards.dot(p[0].cross(p[1])); // of one sign if the line of the ray meets the triangle
    const bool met = (a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0);
    const double sum = a + b + c;
    if (met && sum != 0.0 && (a * p[0] + b * p[1] + c * p[2]).dot(towards) / sum > 0.0)
      return true;
  }
  return false;
}

SpiralPictures::SpiralPictures(PictureScene scene)
: scene_(std::move(scene)), surface_(std::make_unique<DisplaySurface>(displaySurface(scene_)))
{}

SpiralPictures::~SpiralPictures() = default;

} // namespace pcl_spiral
