// SPDX-License-Identifier: BSD-3-Clause
#include "support/solids.h"

#include <cmath>
#include <map>

namespace pcl_spiral::test {

TriangleMesh
cube(double edge)
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(edge * Eigen::Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh
closedCylinder(double radius, double height, std::uint32_t facets)
{
  TriangleMesh mesh;
  for (std::uint32_t k = 0; k < facets; ++k) {
    const double angle = 2.0 * M_PI * k / facets;
    for (const double z : {0.0, height})
      mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  const std::uint32_t bottom = 2 * facets, top = bottom + 1;
  mesh.vertices.push_back(Eigen::Vector3d::Zero());
  mesh.vertices.push_back({0.0, 0.0, height});
  for (std::uint32_t k = 0; k < facets; ++k) {
    const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % facets);
    mesh.faces.push_back({a, b, b + 1});
    mesh.faces.push_back({a, b + 1, a + 1});
    mesh.faces.push_back({bottom, b, a});
    mesh.faces.push_back({top, a + 1, b + 1});
  }
  return mesh;
}

TriangleMesh
icoSphere(double radius, int rounds)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.faces = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int round = 0; round < rounds; ++round) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, added] = middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (added)
        mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& f : mesh.faces) {
      const std::uint32_t a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
    }
    mesh.faces = std::move(finer);
    for (Eigen::Vector3d& v : mesh.vertices)
      v.normalize();
  }
  for (Eigen::Vector3d& v : mesh.vertices)
    v *= radius / v.norm();
  return mesh;
}

TriangleMesh
unwelded(const TriangleMesh& mesh)
{
  TriangleMesh apart;
  for (const auto& f : mesh.faces) {
    const auto first = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t v : f)
      apart.vertices.push_back(mesh.vertices[v]);
    apart.faces.push_back({first, first + 1, first + 2});
  }
  return apart;
}

} // namespace pcl_spiral::test
