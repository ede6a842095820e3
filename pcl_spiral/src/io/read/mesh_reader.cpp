// SPDX-License-Identifier: BSD-3-Clause
#include "face_list.h"
#include "found_format.h"
#include "io/byte_file.h"
#include "polygon_cut.h"
#include "scaled_points.h"
#include "text_encoding.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>

#include <pcl/conversions.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

constexpr std::size_t most_ear_corners = 20000; ///< the time grows with the square: 2 s for this number

MeshTable
readTable(const std::string& file, const std::string& bytes, const std::string& extension)
{
  if (extension == ".stl")
    return readStlMesh(file, bytes);
  refuseWideText(file, bytes);
  if (extension == ".obj")
    return readObjMesh(file, bytes);
  return readPlyMesh(file, bytes);
}

/** \throw FileError if a face has too few corners, or a corner that does not exist or is not finite */
void
checkFaces(const std::string& file, const FaceList& faces, const Points& points)
{
  const auto count = static_cast<std::int64_t>(points.size());
  for (std::size_t f = 0; f < faces.ends.size(); ++f) {
    if (faces.ends[f] - faces.begin(f) < 3)
      throw FileError(file, Diagnostic(faces.nameOf(f), " has ", faces.ends[f] - faces.begin(f),
                                       " corners, but a face needs three; leave it out or export the file again"));
    for (std::size_t i = faces.begin(f); i < faces.ends[f]; ++i) {
      const std::int64_t vertex = faces.corners[i], first = faces.first_vertex;
      if (vertex < 0 || vertex >= count)
        throw FileError(file, Diagnostic(faces.nameOf(f), " names vertex ", vertex + first, ", but the file has vertices ", first, " to ",
                                         count - 1 + first, "; copy or export the file again"));
      const Eigen::Vector3f at = points[static_cast<std::size_t>(vertex)].getVector3fMap();
      if (!at.allFinite())
        throw FileError(file, Diagnostic(faces.nameOf(f), ": its vertex ", vertex + first, " is at ", Place(at.cast<double>()),
                                         ", which is not a place; leave out the faces of this vertex"));
    }
  }
}

/** Puts the faces into a mesh and cuts polygons into triangles. */
class FaceCutter {
public:
  FaceCutter(const std::string& file, const FaceList& faces, const Points& points) : file_(file), faces_(faces), points_(points) {}

  void cutInto(MeshFile& result)
  {
    result.mesh->polygons.reserve(faces_.corners.size() - 2 * faces_.ends.size());
    for (std::size_t f = 0; f < faces_.ends.size(); ++f) {
      takeCorners(f);
      if (corners_.size() == 3) {
        add({0, 1, 2}, *result.mesh);
        continue;
      }
      ++result.polygons;
      for (const CutTriangle& triangle : trianglesOf(f))
        add(triangle, *result.mesh);
    }
    if (faulty_ > 0)
      result.warnings.push_back(Diagnostic(file_, ": ", faces_.nameOf(first_faulty_),
                                           (faulty_ > 1 ? Diagnostic(" and ", faulty_ - 1, " more") : ""),
                                           " can only be cut into triangles that overlap or are flat: the polygon crosses "
                                           "itself or has no area; export the mesh as triangles"));
  }

private:
  /** A corner given twice in sequence counts once, if three are left. */
  void takeCorners(std::size_t face)
  {
    const auto begin = faces_.corners.begin() + static_cast<std::ptrdiff_t>(faces_.begin(face));
    const auto end = faces_.corners.begin() + static_cast<std::ptrdiff_t>(faces_.ends[face]);
    corners_.assign(begin, end);
    if (corners_.size() == 3)
      return;
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    while (corners_.size() > 3 && corners_.back() == corners_.front())
      corners_.pop_back();
    if (corners_.size() < 3)
      corners_.assign(begin, begin + 3);
  }

  std::vector<CutTriangle> trianglesOf(std::size_t face)
  {
    std::vector<Eigen::Vector3d> at;
    for (const std::int64_t corner : corners_)
      at.push_back(points_[static_cast<std::size_t>(corner)].getVector3fMap().cast<double>());
    PolygonCut polygon(at);
    if (polygon.convex())
      return polygon.fan();
    if (at.size() > most_ear_corners)
      throw FileError(file_, Diagnostic(faces_.nameOf(face), " has ", at.size(), " corners and is not convex; the limit for such faces is ",
                                        most_ear_corners, " corners; export the mesh as triangles"));
    const std::vector<CutTriangle> ears = polygon.ears();
    if (polygon.faulty() && faulty_++ == 0)
      first_faulty_ = face;
    return ears;
  }

  void add(const CutTriangle& triangle, pcl::PolygonMesh& mesh) const
  {
    pcl::Vertices vertices;
    vertices.vertices.reserve(3);
    for (const std::size_t corner : triangle)
      vertices.vertices.push_back(static_cast<pcl::index_t>(corners_[corner]));
    mesh.polygons.push_back(std::move(vertices));
  }

  const std::string& file_;
  const FaceList& faces_;
  const Points& points_;
  std::vector<std::int64_t> corners_;
  std::size_t faulty_ = 0, first_faulty_ = 0;
};

} // namespace

const std::vector<std::string>&
meshExtensions()
{
  static const std::vector<std::string> extensions{".stl", ".obj", ".ply"};
  return extensions;
}

MeshFile
readMesh(const std::string& file, const ReadOptions& options)
{
  const std::string extension = lowerExtension(file);
  const auto& known = meshExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end() && !isNameless(file))
    throw FileError(file, Diagnostic("extension '", extension,
                                     "' is not known for a mesh; use .stl .obj or .ply, or read points as a scan ({readCloud})"));
  if (!options.columns.empty())
    throw FileError(file, "only the columns of text files can be named; leave {ReadOptions::columns} out");
  if (options.skip_lines > 0)
    throw FileError(file, "only lines of text files can be skipped; leave {ReadOptions::skip_lines} out");
  const std::string bytes = readStream(file);
  const MeshTable table = readTable(file, bytes, formatOf(file, bytes, known));
  if (table.faces.ends.empty())
    throw FileError(file, Diagnostic("holds no faces, only ", table.vertices[0].size(),
                                     " points; give it as a scan ({readCloud}), or export the mesh with its faces"));
  const ScaledPoints scaled = scaledPoints(file, table.vertices, options);
  const Points::Ptr& points = scaled.cloud;
  checkFaces(file, table.faces, *points);

  MeshFile result;
  result.mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(*points, result.mesh->cloud);
  result.warnings = scaled.warnings;
  result.shift = scaled.shift;
  FaceCutter(file, table.faces, *points).cutInto(result);
  return result;
}

} // namespace pcl_spiral
