// SPDX-License-Identifier: BSD-3-Clause
// Faults planted in meshes, counted by SurfaceMesh and by admesh, a Debian program for solid meshes.
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include "support/sampling.h"
#include "support/scratch_folder.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

namespace mesh_faults_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

std::string
outputOf(const std::string& command)
{
  std::string text;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr)
    return text;
  std::array<char, 512> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
    text += buffer.data();
  pclose(pipe);
  return text;
}

/** The number after \p name and its colon. */
std::size_t
numberBehind(const std::string& text, const std::string& name)
{
  const std::size_t at = text.find(name);
  if (at == std::string::npos)
    return static_cast<std::size_t>(-1);
  return std::strtoull(text.c_str() + text.find(':', at) + 1, nullptr, 10);
}

} // namespace

TEST(MeshFaults, AreCountedAsByAdmesh)
{
  if (std::system("admesh --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "admesh is not installed: bash cmake/install_dependencies.sh test";
  const ScratchFolder folder;
  Random random(5);
  for (std::size_t round = 0; round < 6; ++round) {
    TriangleMesh mesh = icoSphere(50.0, 3);
    std::set<std::size_t> turned, missing;
    while (turned.size() < 3 * round)
      turned.insert(random.below(mesh.faces.size()));
    for (const std::size_t t : turned)
      std::swap(mesh.faces[t][1], mesh.faces[t][2]);
    for (std::size_t k = 0; k < 2 * round; ++k) {
      const auto f = mesh.faces[random.below(mesh.faces.size())];
      mesh.faces.push_back({f[0], f[1], f[0]});
    }
    const std::size_t whole = mesh.faces.size() - 2 * round;
    while (missing.size() < round)
      missing.insert(random.below(whole));
    for (auto it = missing.rbegin(); it != missing.rend(); ++it) {
      mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(*it));
      turned.erase(*it);
    }
    const std::string file = folder.path("faults.stl");
    writeStl(file, mesh);
    SurfaceMesh::ConstPtr surface;
    ASSERT_TRUE(SurfaceMesh::make(*readMesh(file).mesh, {}, surface).ok());
    const MeshReport& counts = surface->report();
    const std::string theirs = outputOf("admesh --exact --normal-directions " + file);
    EXPECT_EQ(counts.without_area.count, numberBehind(theirs, "Degenerate facets")) << theirs;
    EXPECT_EQ(counts.turned.count, numberBehind(theirs, "Facets reversed")) << theirs;
    EXPECT_EQ(counts.turned.count, turned.size());
    EXPECT_EQ(counts.given_faces, numberBehind(theirs, "Number of facets")) << theirs;
    EXPECT_EQ(counts.parts, numberBehind(theirs, "Number of parts")) << theirs;
    const std::size_t open = numberBehind(theirs, "Facets with 1 disconnected edge ") +
                             2 * numberBehind(theirs, "Facets with 2 disconnected edges") +
                             3 * numberBehind(theirs, "Facets with 3 disconnected edges");
    EXPECT_EQ(counts.open_edges.count, open) << theirs;
  }
}

} // namespace mesh_faults_test
