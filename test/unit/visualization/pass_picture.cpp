// SPDX-License-Identifier: BSD-3-Clause
// The picture of passes: on meshes with their own triangles and on clouds, separate passes only, text inside the sheet.
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/mesh/mesh_sections.h>
#include <pcl_spiral/visualization/pass_picture.h>
#include <pcl_spiral/visualization/pictures.h>

#include "support/mesh_surfaces.h"
#include "support/picture_pixels.h"
#include "support/scratch_folder.h"
#include "support/solids.h"
#include "visualization/shown_passes.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <cstdlib>

namespace pass_picture_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Path = pcl::PointCloud<ToolpathPoint>;

constexpr int part_end = 1180; ///< column of pixels; text is right of it

void
add(Path& path, const Eigen::Vector3d& place, const Eigen::Vector3d& normal, std::size_t pass)
{
  ToolpathPoint point;
  point.getVector3fMap() = place.cast<float>();
  point.getNormalVector3fMap() = normal.cast<float>();
  point.turn = static_cast<float>(pass);
  if (!path.empty()) {
    const bool same = path.back().turn == point.turn;
    point.arc_length = path.back().arc_length + (same ? (point.getVector3fMap() - path.back().getVector3fMap()).norm() : 0.0f);
  }
  path.push_back(point);
}

/** A mesh and its section rows. */
PassScene
rowsOn(const TriangleMesh& mesh, double step_over)
{
  PassScene scene;
  MeshSections sections;
  sections.setInputMesh(pcl::PolygonMesh::ConstPtr(mesh.polygons()));
  sections.setStepOver(step_over);
  DrivePasses passes;
  sections.compute(passes);
  EXPECT_TRUE(sections.getStatus().ok()) << sections.getStatus().message();
  const auto path = pcl::make_shared<Path>();
  for (std::size_t pass = 0; pass < passes.size(); ++pass) {
    for (const DrivePoint& point : passes[pass].points)
      add(*path, point.position, point.normal, pass);
    if (passes[pass].closed)
      add(*path, passes[pass].points.front().position, passes[pass].points.front().normal, pass);
  }
  scene.title = "rows.stl";
  scene.mesh = sections.getSurfaceMesh();
  scene.path = path;
  scene.cutter = CutterShape::ball(3.0);
  scene.step_over = sections.getReport().step_over;
  return scene;
}

/** Level passes on a square plate of 100 mm. */
PassScene
plate(std::size_t passes)
{
  PassScene scene;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < 101; ++i)
    for (int j = 0; j < 101; ++j)
      cloud->emplace_back(static_cast<float>(i), static_cast<float>(j) + 0.3f * static_cast<float>(i % 2), 0.0f);
  const auto path = pcl::make_shared<Path>();
  scene.step_over = passes > 1 ? 100.0 / static_cast<double>(passes - 1) : 0.0;
  for (std::size_t pass = 0; pass < passes; ++pass)
    for (int i = 0; i <= 100; ++i)
      add(*path, {pass % 2 == 0 ? i : 100.0 - i, static_cast<double>(pass) * scene.step_over, 0.0}, Eigen::Vector3d::UnitZ(), pass);
  scene.title = "plate";
  scene.cloud = cloud;
  scene.path = path;
  scene.cutter = CutterShape::bullNose(6.0, 1.0);
  return scene;
}

bool
isColored(const Pixel& p)
{
  const auto [low, high] = std::minmax({p[0], p[1], p[2]});
  return high - low > 40;
}

/** Number of changes from gray to a line, upwards in a column of pixels over the part. */
int
linesAcross(vtkImageData* image, int x)
{
  int lines = 0;
  bool on_gray = false;
  for (int y = 0; y < 1090; ++y) {
    const Pixel pixel = at(image, x, y);
    const bool is_line = isColored(pixel);
    lines += on_gray && is_line;
    on_gray = !is_line && (on_gray || isGray(pixel));
  }
  return lines;
}

} // namespace

TEST(PassPicture, AsManyPassesAsStandApart)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  for (const std::size_t passes : {2, 20, 100, 1000}) {
    const PassScene scene = plate(passes);
    writePasses(folder.path("a.png"), scene);
    const int lines = linesAcross(readPicture(folder.path("a.png")), 590);
    if (passes <= 100)
      EXPECT_NEAR(lines, static_cast<int>(passes), 2) << "every one";
    else
      EXPECT_GT(lines, 80) << passes;
    EXPECT_LT(lines, 280) << passes;
  }
}

TEST(PassPicture, PassesBesideEachOtherInAnyOrderAreShownAlike)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  // each row in two pieces, left and right, in sequence: every second pass would be only one side
  PassScene scene = plate(1);
  const auto path = pcl::make_shared<Path>();
  for (std::size_t row = 0; row < 600; ++row)
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i <= 40; ++i)
        add(*path, {60.0 * side + i, static_cast<double>(row) / 6.0, 0.0}, Eigen::Vector3d::UnitZ(),
            2 * row + static_cast<std::size_t>(side));
  scene.path = path;
  scene.step_over = 1.0 / 6.0;
  const ScratchFolder folder;
  writePasses(folder.path("a.png"), scene);
  const auto image = readPicture(folder.path("a.png"));
  const int left = linesAcross(image, 330), right = linesAcross(image, 850);
  EXPECT_GT(left, 60);
  EXPECT_NEAR(left, right, 4);
  EXPECT_EQ(linesAcross(image, 590), 0) << "no line between the pieces, where the tool is lifted";
}

TEST(PassPicture, AMeshIsDrawnWhole)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  const PassScene scene = rowsOn(cube(40.0), 2.0);
  writePasses(folder.path("a.png"), scene);
  const auto counts = colorsOf(folder.path("a.png"), 0, part_end);
  // flat faces between sharp edges have few grays, smooth ones many
  std::size_t largest = 0;
  for (const auto& [pixel, count] : counts)
    if (isGray(pixel))
      largest = std::max(largest, count);
  EXPECT_GT(largest, 20000U);
  EXPECT_GT(share(counts, isWhite), 0.30);
  EXPECT_LT(share(counts, isWhite), 0.75);
  const PassScene land = rowsOn(gridMesh(*landform(), {100.0, 100.0}, 25, 0.3), 2.5);
  writePasses(folder.path("b.png"), land);
  EXPECT_NEAR(linesAcross(readPicture(folder.path("b.png")), 590), static_cast<int>(passBegins(*land.path).size()) + 1, 3);
  EXPECT_GT(colorsOf(folder.path("b.png"), 0, part_end).size(), 1000U) << "is shaded";
  EXPECT_EQ(readText(folder.path("b.png")), (writePasses(folder.path("c.png"), land), readText(folder.path("c.png"))));
}

TEST(PassPicture, WordsStayInsideTheSheet)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  PassScene scene = plate(8000);
  scene.cutter = CutterShape::taperedBullNose(6.125, 1.0625, 20.0, 7.5);
  writePasses(folder.path("a.png"), scene);
  const auto image = readPicture(folder.path("a.png"));
  for (int y = 0; y < 1200; ++y)
    for (const int x : {0, 1, 2, 1597, 1598, 1599})
      ASSERT_TRUE(isWhite(at(image, x, y))) << x << ' ' << y;
}

TEST(PassPicture, ASinglePassMayHaveTurnsOrNone)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  PassScene scene = plate(1);
  writePasses(folder.path("one.png"), scene);
  const int line = linesAcross(readPicture(folder.path("one.png")), 590);
  EXPECT_LE(line, 1); // on the rim: gray on one side
  scene.path.reset();
  EXPECT_THROW(writePasses(folder.path("a.png"), scene), std::invalid_argument);
  scene = plate(3);
  scene.cloud.reset();
  EXPECT_THROW(writePasses(folder.path("a.png"), scene), std::invalid_argument);
  EXPECT_THROW(writePasses(folder.path("nowhere/a.png"), plate(3)), FileError);
}

TEST(PassPicture, WordsCountPassesShown)
{
  ShownPasses shown;
  shown.shown = {true, true, true};
  shown.seen = 3;
  EXPECT_EQ(shown.caption("pass"), "every pass shown");
  shown.shown[1] = false;
  EXPECT_EQ(shown.caption("turn"), "2 of 3 turns shown");
  shown.seen = 2;
  EXPECT_EQ(shown.caption("pass"), "2 of 3 passes shown, the rest hidden");
  EXPECT_TRUE(shown.shows(0.7));
  EXPECT_FALSE(shown.shows(1.0));
  EXPECT_TRUE(shown.shows(3.0)) << "where the last turn ends";
}

} // namespace pass_picture_test
