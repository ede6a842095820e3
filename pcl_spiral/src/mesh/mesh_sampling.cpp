// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/mesh_sampling.h>

#include "dart_throwing.h"
#include "face_lattice.h"
#include "rim_samples.h"

#include "common/available_memory.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/mesh/impl/crease_lines.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double apart = 0.68, lattice_step = 0.22, rim_step = 0.8, rims_apart = 0.3; // spacings
constexpr double bytes_a_candidate = 48.0;

/** A place on a face: shares of the corners as FaceLattice has them. */
struct FacePlace {
  std::uint32_t face;
  float along, up;
};

/** The finaliser of SplitMix64 over the bits of a place; Steele, Lea, Flood 2014. Never 0. */
std::uint32_t
priorityOf(const Vector3d& p)
{
  std::uint64_t hash = 0;
  for (int d = 0; d < 3; ++d) {
    const double value = p[d] + 0.0; // no -0
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    hash += bits + 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
    hash ^= hash >> 31;
  }
  return std::max(1u, static_cast<std::uint32_t>(hash >> 32));
}

/** Samples one mesh. */
class Sampler {
public:
  Sampler(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen, double spacing)
  : mesh_(mesh), chosen_(chosen), spacing_(spacing)
  {}

  Status run(pcl::PointCloud<pcl::PointNormal>& output, std::vector<std::uint32_t>& faces)
  {
    if (const Status status = count(); !status.ok())
      return status;
    rims_ = rimSamples(mesh_, chosen_, rim_step * spacing_, rims_apart * spacing_);
    addDarts();
    for (const std::uint32_t i : throwDarts(darts_, apart * spacing_)) {
      pcl::PointNormal point;
      point.getVector3fMap() = darts_[i].position;
      if (i < rims_.size()) {
        point.getNormalVector3fMap() = rims_[i].normal;
        faces.push_back(rims_[i].face);
      }
      else {
        const FacePlace& place = places_[i - rims_.size()];
        point.getNormalVector3fMap() = FaceLattice(mesh_, place.face, spacing_).patch().normal(shares(place)).cast<float>();
        faces.push_back(place.face);
      }
      output.push_back(point);
    }
    return Status::success();
  }

private:
  static Vector3d shares(const FacePlace& place)
  {
    const double along = place.along, up = place.up;
    return {1.0 - along - up, along, up};
  }

  bool isChosen(std::size_t face) const { return chosen_.empty() || chosen_[face]; }

  Status tooMany(double candidates) const
  {
    const double bytes = bytes_a_candidate * candidates;
    const auto memory = availableMemory();
    if (candidates < 4e9 && !(memory && bytes > *memory))
      return Status::success();
    return {StatusCode::InvalidArgument,
            Diagnostic("sampling the mesh's ", mesh_.area(), " {mm2} every ", spacing_, " {mm} needs ", std::ceil(1e-6 * candidates),
                       " million places and ", std::ceil(1e-9 * bytes), " GB of memory, but only ", memory ? 1e-9 * *memory : 0.0,
                       " GB are free: raise the spacing ({setSpacing}), or set it to 0 to have it chosen")};
  }

  /** Count the candidates of each face; refuse too many. */
  Status count()
  {
    const double step = lattice_step * spacing_;
    double foreseen = 0.0;
    Eigen::AlignedBox3d box;
    for (std::size_t t = 0; t < mesh_.faceCount(); ++t)
      if (isChosen(t)) {
        foreseen += 1.0 + mesh_.faceArea(t) / (step * step);
        for (const std::uint32_t v : mesh_.triangles().triangle(t))
          box.extend(mesh_.position(v));
      }
    if (box.isEmpty())
      return {StatusCode::InvalidInput, "no face of the mesh is chosen: choose some ({setFaces}), or give no choice to take all"};
    if (box.sizes().maxCoeff() > most_dart_cells * apart * spacing_)
      return {StatusCode::InvalidArgument, Diagnostic("a spacing of ", spacing_, " {mm} is too close for a mesh ", box.sizes().maxCoeff(),
                                                      " {mm} long: raise it ({setSpacing}), or check the units")};
    if (const Status status = tooMany(foreseen); !status.ok())
      return status;
    first_.assign(mesh_.faceCount() + 1, 0);
#pragma omp parallel for schedule(dynamic, 1024)
    for (std::int64_t t = 0; t < static_cast<std::int64_t>(mesh_.faceCount()); ++t)
      first_[t + 1] = isChosen(t) ? FaceLattice(mesh_, t, step).count() : 0;
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    return tooMany(static_cast<double>(first_.back()));
  }

  void addDarts()
  {
    for (const RimSample& sample : rims_)
      darts_.push_back({sample.position, 0});
    const std::size_t rims = darts_.size();
    darts_.resize(rims + first_.back());
    places_.resize(first_.back());
#pragma omp parallel for schedule(dynamic, 1024)
    for (std::int64_t t = 0; t < static_cast<std::int64_t>(mesh_.faceCount()); ++t) {
      if (!isChosen(t))
        continue;
      const FaceLattice lattice(mesh_, t, lattice_step * spacing_);
      std::size_t at = first_[t];
      for (std::size_t column = 0; column < lattice.columns(); ++column)
        for (std::size_t row = 0; row < lattice.rows(column); ++row, ++at) {
          const Vector3d b = lattice.place(column, row);
          places_[at] = {static_cast<std::uint32_t>(t), static_cast<float>(b[1]), static_cast<float>(b[2])};
          const Vector3d rounded = shares(places_[at]);
          darts_[rims + at] = {lattice.patch().position(rounded).cast<float>(), priorityOf(lattice.patch().corners * rounded)};
        }
    }
  }

  const SurfaceMesh& mesh_;
  const std::vector<std::uint8_t>& chosen_;
  double spacing_;
  std::vector<std::size_t> first_; ///< candidate of each face
  std::vector<RimSample> rims_;
  std::vector<Dart> darts_; ///< of the rims, then of the faces
  std::vector<FacePlace> places_;
};

} // namespace

void
MeshSampling::setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh)
{
  input_ = mesh;
  mesh_.reset();
}

void
MeshSampling::setInputMesh(const SurfaceMesh::ConstPtr& mesh)
{
  input_.reset();
  mesh_ = mesh;
}

Status
MeshSampling::run(pcl::PointCloud<pcl::PointNormal>& output)
{
  if (const Status status = checkThreads(thread_count_); !status.ok())
    return status;
  if (!input_ && !mesh_)
    return {StatusCode::InvalidInput, "there is no mesh: call {setInputMesh}"};
  if (!(spacing_ >= 0.0) || !std::isfinite(spacing_))
    return {StatusCode::InvalidArgument,
            Diagnostic("the spacing is ", spacing_, " {mm}; set it above 0, or to 0 to have it chosen ({setSpacing})")};
  if (!(crease_band_ >= 0.0) || !std::isfinite(crease_band_))
    return {StatusCode::InvalidArgument,
            Diagnostic("the crease band is ", crease_band_, " {mm} wide; set it to 0 or more ({setCreaseBand})")};
  const ThreadLimit limit(thread_count_);
  if (input_)
    if (const Status status = SurfaceMesh::make(*input_, settings_, mesh_); !status.ok())
      return status;
  if (!chosen_.empty() && chosen_.size() != mesh_->faceCount())
    return {StatusCode::InvalidInput, Diagnostic("faces are chosen by ", chosen_.size(), " values, but the mesh has ", mesh_->faceCount(),
                                                 " faces: give one value per face, or none for all ({setFaces})")};
  used_spacing_ = spacing_ > 0.0 ? spacing_ : defaultSampleSpacing(*mesh_, chosen_);
  if (const Status status = Sampler(*mesh_, chosen_, used_spacing_).run(output, faces_); !status.ok())
    return status;
  in_band_.assign(output.size(), 0);
  if (!(crease_band_ > 0.0))
    return Status::success();
  const CreaseLines creases(*mesh_, chosen_);
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(output.size()); ++i)
    in_band_[i] = creases.distance(output[i].getVector3fMap().cast<double>(), crease_band_) < crease_band_;
  return Status::success();
}

void
MeshSampling::compute(pcl::PointCloud<pcl::PointNormal>& output)
{
  output.clear();
  faces_.clear();
  in_band_.clear();
  status_ = run(output);
}

} // namespace pcl_spiral
