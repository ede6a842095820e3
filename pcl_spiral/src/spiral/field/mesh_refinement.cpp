// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_refinement.h"

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

using Triangle = Triangulation::Triangle;

/** Cuts triangles into a lattice; nodes on shared edges are made once. */
class Refiner {
public:
  Refiner(StepOverMesh coarse, const std::vector<std::uint8_t>& chosen, int parts)
  : triangulation_(std::move(coarse.triangles)), rims_(std::move(coarse.rims)), nodes_(coarse.size()), chosen_(chosen), parts_(parts),
    on_edge_(triangulation_.halfEdgeCount(), Triangulation::none)
  {
    fine_.positions = std::move(coarse.positions);
    fine_.normals = std::move(coarse.normals);
    fine_.metric = std::move(coarse.metric);
    lattice_.resize(static_cast<std::size_t>((parts_ + 1) * (parts_ + 2) / 2));
    for (std::size_t i = 0; i < chosen_.size(); ++i)
      if (chosen_[i])
        cut_.push_back(i);
    reserve();
  }

  StepOverMesh run(std::vector<std::uint8_t>& is_fine)
  {
    const Triangulation& t = triangulation_;
    for (const std::size_t i : cut_)
      for (std::uint32_t h = static_cast<std::uint32_t>(3 * i); h < 3 * i + 3; ++h)
        cutEdge(h);
    for (const std::size_t i : cut_)
      cutTriangle(i);
    is_fine.assign(fine_.size(), 1);
    std::vector<std::uint8_t> touched(nodes_, 0);
    for (const std::size_t i : cut_)
      for (const std::uint32_t v : t.triangle(i))
        touched[v] = 1;
    std::copy(touched.begin(), touched.end(), is_fine.begin());
    for (std::size_t i = 0; i < t.triangleCount(); ++i) {
      const Triangle& corners = t.triangle(i);
      if (!touched[corners[0]] && !touched[corners[1]] && !touched[corners[2]])
        triangles_.push_back(corners);
      else if (!chosen_[i])
        keepTriangle(i);
    }
    is_fine.resize(fine_.size(), 0);
    cutRims();
    triangulation_ = Triangulation(); // not beside the new one
    std::vector<std::uint32_t>().swap(on_edge_);
    fine_.triangles = Triangulation(fine_.size(), std::move(triangles_));
    return std::move(fine_);
  }

private:
  /** Room for the new nodes and triangles: about half as many nodes as triangles. */
  void reserve()
  {
    const std::size_t cut = cut_.size(), pieces = static_cast<std::size_t>(parts_) * static_cast<std::size_t>(parts_),
                      nodes = nodes_ + cut * pieces / 2 + cut;
    fine_.positions.reserve(nodes);
    fine_.normals.reserve(nodes);
    fine_.metric.reserve(nodes);
    triangles_.reserve(triangulation_.triangleCount() + cut * pieces + cut);
  }
  std::uint32_t canonical(std::uint32_t h) const
  {
    const std::uint32_t other = triangulation_.opposite(h);
    return other == Triangulation::none ? h : std::min(h, other);
  }
  std::uint32_t add(const Triangle& corners, double a, double b, double c)
  {
    const Eigen::Vector3d position = a * fine_.positions[corners[0]] + b * fine_.positions[corners[1]] + c * fine_.positions[corners[2]];
    fine_.positions.push_back(position);
    const Eigen::Vector3d normal = a * fine_.normals[corners[0]].cast<double>() + b * fine_.normals[corners[1]].cast<double>() +
                                   c * fine_.normals[corners[2]].cast<double>();
    fine_.normals.push_back(normal.normalized().cast<float>());
    StepOverMetric metric = fine_.metric[corners[0]].times(a);
    metric += fine_.metric[corners[1]].times(b);
    metric += fine_.metric[corners[2]].times(c);
    fine_.metric.push_back(metric);
    return static_cast<std::uint32_t>(fine_.positions.size() - 1);
  }
  void cutEdge(std::uint32_t h)
  {
    const std::uint32_t edge = canonical(h);
    if (on_edge_[edge] != Triangulation::none)
      return;
    on_edge_[edge] = static_cast<std::uint32_t>(fine_.size());
    const Triangle ends{triangulation_.origin(edge), triangulation_.target(edge), 0};
    for (int i = 1; i < parts_; ++i)
      add({ends[0], ends[1], ends[1]}, 1.0 - static_cast<double>(i) / parts_, static_cast<double>(i) / parts_, 0.0);
  }
  /** Node \p step of half-edge \p h, from 0 at its origin to parts at its target. */
  std::uint32_t edgeNode(std::uint32_t h, int step) const
  {
    if (step == 0 || step == parts_)
      return step == 0 ? triangulation_.origin(h) : triangulation_.target(h);
    const std::uint32_t edge = canonical(h);
    return on_edge_[edge] + static_cast<std::uint32_t>(edge == h ? step - 1 : parts_ - 1 - step);
  }
  void cutTriangle(std::size_t t)
  {
    const Triangle corners = triangulation_.triangle(t);
    const auto h = static_cast<std::uint32_t>(3 * t);
    // Row i from corner 0, place j in it: weights 1 - i/n, (i - j)/n, j/n.
    const auto at = [this](int i, int j) -> std::uint32_t& {
      const int place = i * (i + 1) / 2 + j;
      return lattice_[static_cast<std::size_t>(place)];
    };
    for (int i = 0; i <= parts_; ++i)
      for (int j = 0; j <= i; ++j) {
        if (j == 0)
          at(i, j) = edgeNode(h, i);
        else if (i == parts_)
          at(i, j) = edgeNode(h + 1, j);
        else if (j == i)
          at(i, j) = edgeNode(h + 2, parts_ - i);
        else
          at(i, j) =
              add(corners, 1.0 - static_cast<double>(i) / parts_, static_cast<double>(i - j) / parts_, static_cast<double>(j) / parts_);
      }
    for (int i = 0; i < parts_; ++i)
      for (int j = 0; j <= i; ++j) {
        triangles_.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        if (j < i)
          triangles_.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  void keepTriangle(std::size_t t)
  {
    const auto first = static_cast<std::uint32_t>(3 * t);
    const auto isCut = [this](std::uint32_t h) { return on_edge_[canonical(h)] != Triangulation::none; };
    if (!isCut(first) && !isCut(first + 1) && !isCut(first + 2)) {
      triangles_.push_back(triangulation_.triangle(t));
      return;
    }
    std::vector<std::uint32_t> ring;
    for (std::uint32_t h = first; h < first + 3; ++h)
      for (int i = 0; i < (isCut(h) ? parts_ : 1); ++i)
        ring.push_back(i == 0 ? triangulation_.origin(h) : edgeNode(h, i));
    const std::uint32_t middle = add(triangulation_.triangle(t), 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
      triangles_.push_back({ring[i], ring[(i + 1) % ring.size()], middle});
  }
  void cutRims()
  {
    const Triangulation& t = triangulation_;
    for (const std::vector<std::uint32_t>& rim : rims_) {
      std::vector<std::uint32_t> fine;
      for (std::size_t i = 0; i < rim.size(); ++i) {
        fine.push_back(rim[i]);
        const std::uint32_t next = rim[(i + 1) % rim.size()];
        for (std::size_t o = t.outgoingBegin(rim[i]); o < t.outgoingBegin(rim[i] + 1); ++o) {
          const std::uint32_t h = t.outgoing(o);
          if (t.target(h) == next && t.opposite(h) == Triangulation::none && on_edge_[h] != Triangulation::none)
            for (int step = 1; step < parts_; ++step)
              fine.push_back(edgeNode(h, step));
        }
      }
      fine_.rims.push_back(std::move(fine));
    }
  }

  Triangulation triangulation_; ///< of the coarse mesh
  std::vector<std::vector<std::uint32_t>> rims_;
  std::size_t nodes_; ///< of the coarse mesh, which come first in the fine one
  const std::vector<std::uint8_t>& chosen_;
  int parts_;
  std::vector<std::uint32_t> on_edge_; ///< first node inside each half-edge that represents its edge
  StepOverMesh fine_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> cut_;       ///< the chosen triangles
  std::vector<std::uint32_t> lattice_; ///< nodes of the triangle that is cut, row by row from corner 0
};

} // namespace

StepOverMesh
refined(StepOverMesh mesh, const std::vector<std::uint8_t>& chosen, int parts, std::vector<std::uint8_t>& is_fine)
{
  return Refiner(std::move(mesh), chosen, parts).run(is_fine);
}

} // namespace pcl_spiral
