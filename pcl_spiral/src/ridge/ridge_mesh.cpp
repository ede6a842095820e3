// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/ridge/ridge_surface.h>

#include <pcl_spiral/core/diagnostic.h>

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double most_faces = 1e6;

/** Number of stations at which the curvature is measured. */
int
stationsOf(const SmoothLine& line, double a_mm, double least, double most)
{
  return static_cast<int>(std::clamp(a_mm * line.length(), least, most));
}

/** How the frame turns along the rail (\see ridgeTurn), and how that changes. */
struct Turn {
  Vector3d omega, change;
};

Turn
turnAt(const RidgeSurface& surface, double u)
{
  constexpr double d = 1e-3; // mm, step of the finite differences
  const SmoothLine& rail = surface.rail();
  const auto omega = [&](double at) { return ridgeTurn(surface.frame(at), rail.curvature(at), surface.chord().reference); };
  const double low = rail.closed() ? u - d : std::max(u - d, 0.0), high = rail.closed() ? u + d : std::min(u + d, rail.length());
  return {omega(u), (omega(high) - omega(low)) / (high - low)};
}

/** Largest magnitudes of the second fundamental form: along the rail, mixed, along the generator, 1/mm. */
struct Bending {
  double along = 0.0, mixed = 0.0, across = 0.0;
};

/** All in directions of the frame: S_u = e_x + omega x g, S_v = g'; the turn of the frame adds omega x S_u to the derivative. */
Bending
largestBending(const RidgeSurface& surface)
{
  const SmoothLine &rail = surface.rail(), &generator = surface.generator();
  const int rail_stations = stationsOf(rail, 2.0, 400.0, 20000.0), stations = stationsOf(generator, 4.0, 100.0, 400.0);
  struct Place {
    Vector3d g, first, second;
  };
  std::vector<Place> places;
  for (int j = 0; j <= stations; ++j) {
    const double v = generator.length() * j / stations;
    places.push_back({generator.position(v), generator.tangent(v), generator.curvature(v)});
  }
  Bending most;
  for (int i = 0; i <= rail_stations; ++i) {
    const Turn turn = turnAt(surface, rail.length() * i / rail_stations);
    for (const Place& at : places) {
      const Vector3d s_u = Vector3d::UnitX() + turn.omega.cross(at.g), n = s_u.cross(at.first).normalized();
      most.along = std::max(most.along, std::abs(n.dot(turn.omega.cross(s_u) + turn.change.cross(at.g))));
      most.mixed = std::max(most.mixed, std::abs(n.dot(turn.omega.cross(at.first))));
      most.across = std::max(most.across, std::abs(n.dot(at.second)));
    }
  }
  return most;
}

/** Numbers of cells along rail and generator. */
struct Cells {
  double along = 0.0, across = 0.0;

  double faces() const { return 2.0 * along * across; }
};

/** A right-angled face with legs du and dv is off by at most (|L| du^2 + 2 |M| du dv + |N| dv^2) / 8, with L, M, N of the second
 *  fundamental form. The number of cells is least if both legs have the same sag. */
Cells
cellsFor(const RidgeSurface& surface, const Bending& most, double chord_error)
{
  constexpr double longest = 4.0; // times as long as wide
  constexpr double least_across = 8.0, least_along = 8.0;
  constexpr double share = 0.95; // reserve, because the curvature is measured only at stations
  const double tiny = 1e-12;     // 1/mm
  const double ratio = std::clamp(std::sqrt((most.along + tiny) / (most.across + tiny)), 1.0 / longest, longest); // dv / du
  const double bending = most.along + 2.0 * most.mixed * ratio + most.across * ratio * ratio + tiny;
  double du = std::sqrt(8.0 * share * chord_error / bending);
  du = std::min({du, surface.rail().length() / least_along, surface.generator().length() / (least_across * ratio)});
  return {std::ceil(surface.rail().length() / du), std::ceil(surface.generator().length() / (ratio * du))};
}

void
addVertices(const RidgeSurface& surface, RidgeMesh& mesh)
{
  const SmoothLine &rail = surface.rail(), &generator = surface.generator();
  Polyline local;
  for (std::size_t j = 0; j <= mesh.across; ++j)
    local.push_back(generator.position(generator.length() * static_cast<double>(j) / static_cast<double>(mesh.across)));
  const std::size_t stations = mesh.along + (rail.closed() ? 0 : 1);
  for (std::size_t i = 0; i < stations; ++i) {
    const double u = rail.length() * static_cast<double>(i) / static_cast<double>(mesh.along);
    const Vector3d foot = rail.position(u);
    const RidgeFrame frame = surface.frame(u);
    for (const Vector3d& g : local)
      mesh.vertices.push_back(foot + frame.turned(g));
  }
}

void
addFaces(bool closed, RidgeMesh& mesh)
{
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>((closed && i == mesh.along ? 0 : i) * (mesh.across + 1) + j);
  };
  for (std::size_t i = 0; i < mesh.along; ++i)
    for (std::size_t j = 0; j < mesh.across; ++j) {
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
}

} // namespace

pcl::PolygonMesh
RidgeMesh::polygons() const
{
  pcl::PointCloud<pcl::PointXYZ> points;
  for (const Vector3d& p : vertices)
    points.push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(points, mesh.cloud);
  mesh.polygons.resize(faces.size());
  for (std::size_t t = 0; t < faces.size(); ++t)
    mesh.polygons[t].vertices.assign(faces[t].begin(), faces[t].end());
  return mesh;
}

Status
ridgeMesh(const RidgeSurface& surface, double chord_error, RidgeMesh& mesh)
{
  mesh = {};
  if (!(chord_error > 0.0) || !std::isfinite(chord_error))
    return {StatusCode::InvalidArgument, Diagnostic("the chord error of the ridge's mesh is ", chord_error, " {mm}: set it above 0")};
  const Bending bending = largestBending(surface);
  const Cells cells = cellsFor(surface, bending, chord_error), fewest = cellsFor(surface, bending, std::numeric_limits<double>::infinity());
  if (fewest.faces() > most_faces)
    return {StatusCode::InvalidInput,
            Diagnostic("a ridge ", surface.rail().length(), " {mm} long and ", surface.generator().length(), " {mm} wide needs ",
                       fewest.faces(), " faces, but at most ", most_faces, " are possible: make it in pieces")};
  if (cells.faces() > most_faces) { // their number is proportional to 1 / chord error
    constexpr double rounded_up = 1.1;
    return {StatusCode::InvalidArgument,
            Diagnostic("a chord error of ", chord_error, " {mm} needs ", cells.faces(), " faces, but at most ", most_faces,
                       " are possible: raise it to ", rounded_up * chord_error * cells.faces() / most_faces, " {mm}")};
  }
  mesh.along = static_cast<std::size_t>(cells.along);
  mesh.across = static_cast<std::size_t>(cells.across);
  addVertices(surface, mesh);
  addFaces(surface.rail().closed(), mesh);
  return Status::success();
}

Status
ridgeMesh(const RidgeSurface& surface, double chord_error, SurfaceMesh::ConstPtr& mesh)
{
  mesh.reset();
  RidgeMesh triangles;
  if (const Status status = ridgeMesh(surface, chord_error, triangles); !status.ok())
    return status;
  MeshSettings settings;
  settings.crease_angle = 180.0; // both lines are smooth
  return SurfaceMesh::make(triangles.polygons(), settings, mesh);
}

} // namespace pcl_spiral
