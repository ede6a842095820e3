// SPDX-License-Identifier: BSD-3-Clause
// Settings of a spiral that contradict each other, or have no meaning: each remedy that the refusal names makes a path.
#include "support/plain_mesh.h"
#include "support/spiral_jobs.h"

#include <gtest/gtest.h>

namespace settings_remedies_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;
using Change = SpiralChange;

RemediedJob
onPlate(const char* words, const Change& change, const SpiralRemedies& remedies)
{
  return spiralOver(disc, words, change, remedies);
}

void
setTool(Spiral& planner)
{
  planner.setToolRadius(3.0);
  planner.setScallopHeight(0.05);
}

Prism
square(double x, double y, double half)
{
  return box(x - half, x + half, y - half, y + half);
}

SurfaceMesh::ConstPtr
mesh()
{
  return graphMesh([](double x, double y) { return -0.002 * (x * x + y * y); }, 6.0, 1.5).surface();
}

/** A mesh, after \p change is refused. The first has the other remedy of all, a scan in place of the mesh. */
RemediedJob
onMesh(const char* setter, const Change& change, const Change& back, const SpiralRemedies& more = {})
{
  const Change prepare = [change](Spiral& planner) {
    planner.setInputMesh(mesh());
    setTool(planner);
    change(planner);
  };
  SpiralRemedies remedies = more;
  remedies.push_back({setter, back});
  return remediedJob<Spiral>(" belongs to scans, and a mesh is given", saySpiral, prepare, remedies);
}

} // namespace

TEST(SettingsRemedies, Ranges)
{
  expectNoFaults({
      onPlate("the tool radius is ", [](Spiral& s) { s.setToolRadius(0.0); }, {{"setToolRadius", [](Spiral& s) { s.setToolRadius(3.0); }}}),
      onPlate("must be below the tool radius", [](Spiral& s) { s.setScallopHeight(3.0); },
              {{"setScallopHeight", [](Spiral& s) { s.setScallopHeight(0.03); }}}),
      onPlate("the chord error is ", [](Spiral& s) { s.setChordError(3.0); },
              {{"setChordError", [](Spiral& s) { s.setChordError(0.005); }}}),
      onPlate("the fixed tool axis is ", [](Spiral& s) { s.setFixedAxis(Vector3d::Zero()); },
              {{"setFixedAxis", [](Spiral& s) { s.setFixedAxis(Vector3d::UnitZ()); }}}),
      onPlate("the number of threads is ", [](Spiral& s) { s.setNumberOfThreads(4000000000U); },
              {{"setNumberOfThreads", [](Spiral& s) { s.setNumberOfThreads(0); }}}),
      onPlate("the distance of samples is ", [](Spiral& s) { s.setSampleSpacing(-1.0); },
              {{"setSampleSpacing", [](Spiral& s) { s.setSampleSpacing(0.0); }}}),
      onPlate("the distance from the ball to the holder is ", [](Spiral& s) { s.setHolder({ToolSegment::cylinder(4.0, 30.0, "chuck")}); },
              {{"setFlankLength", [](Spiral& s) { s.setFlankLength(40.0); }}}),
  });
}

TEST(SettingsRemedies, Contradictions)
{
  const auto scallop = [](Spiral& s) { s.setMethod(SpiralMethod::ConstantScallop); };
  const auto radial = [](Spiral& s) { s.setMethod(SpiralMethod::Radial); };
  const char* const no_lines = ", but a path at constant scallop height has no centre and no radial";
  expectNoFaults({
      onPlate("the path is set to run over holes",
              [](Spiral& s) {
                s.setHoleHandling(HoleHandling::Over);
                s.setBoundaryMode(BoundaryMode::AllBoundaries);
                s.setMethod(SpiralMethod::ConstantScallop);
              },
              {{"setHoleHandling", [](Spiral& s) { s.setHoleHandling(HoleHandling::Around); }},
               {"setBoundaryMode", [](Spiral& s) { s.setBoundaryMode(BoundaryMode::Automatic); }}}),
      onPlate("two boundaries were set, but the surface has only one", [](Spiral& s) { s.setBoundaryMode(BoundaryMode::TwoBoundaries); },
              {{"setBoundaryMode", [](Spiral& s) { s.setBoundaryMode(BoundaryMode::OneBoundary); }}}),
      onPlate(no_lines, [&](Spiral& s) { scallop(s), s.setCenter(Vector3d::Zero()); },
              {{"setCenter", [](Spiral& s) { s.clearCenter(); }}, {"setMethod", radial}}),
      onPlate(no_lines, [&](Spiral& s) { scallop(s), s.setLineMethod(LineMethod::Harmonic); },
              {{"setLineMethod", [](Spiral& s) { s.setLineMethod(LineMethod::Automatic); }}, {"setMethod", radial}}),
      onPlate(no_lines, [&](Spiral& s) { scallop(s), s.setPitch(Pitch::AlongLine); },
              {{"setPitch", [](Spiral& s) { s.setPitch(Pitch::AcrossFeed); }}, {"setMethod", radial}}),
      onPlate("belongs to one region, and several are given",
              [](Spiral& s) {
                s.setCenter({-7.0, 0.0, 0.0});
                s.addRegion({square(-8.0, 0.0, 7.0), std::nullopt, ""});
                s.addRegion({square(8.0, 0.0, 7.0), std::nullopt, ""});
              },
              {{"setCenter", [](Spiral& s) { s.clearCenter(); }},
               {"addRegion",
                [](Spiral& s) {
                  s.clearPart();
                  s.addRegion({square(-8.0, 0.0, 7.0), std::nullopt, ""});
                }}}),
  });
}

TEST(SettingsRemedies, TheInput)
{
  const auto give = [](Spiral& s) { s.setInputCloud(plate()); };
  const auto surfaceOf = [](Spiral& s) {
    ScannedSurface<pcl::PointXYZ> scanned;
    scanned.setInputCloud(plate());
    Surface::ConstPtr surface;
    scanned.compute(surface);
    s.setInputSurface(surface);
  };
  const auto indices = [](const pcl::Indices& some) {
    return [some](Spiral& s) { s.setIndices(pcl::IndicesPtr(new pcl::Indices(some))); };
  };
  expectNoFaults({
      remediedJob<Spiral>("the input cloud is missing", saySpiral, setTool,
                          {{"setInputCloud", give}, {"setInputMesh", [](Spiral& s) { s.setInputMesh(mesh()); }}}),
      onPlate("the whole scan is needed", surfaceOf,
              {{"setInputSurface", [](Spiral& s) { s.setInputSurface(nullptr); }},
               {"setInputCloud", give},
               {"SpiralToolpathGenerator", [](Spiral& s) { s.setInputSurface(nullptr); }}}),
      onPlate("the indices are empty", indices({}), {{"setIndices", [](Spiral& s) { s.setIndices(pcl::IndicesPtr()); }}}),
      onPlate("is {number} {mm} from the nearest point of the {scan}",
              [](Spiral& s) {
                s.setPartAt({500.0, 0.0, 0.0});
              },
              {{"setPartAt",
                [](Spiral& s) {
                  s.setPartAt({5.0, 0.0, 0.0});
                }}}),
      onPlate("no point is left",
              [](Spiral& s) {
                s.setCropBox({Vector3d(50.0, 50.0, 0.0), Vector3d(60.0, 60.0, 1.0)});
              },
              {{"setCropBox",
                [](Spiral& s) {
                  s.setCropBox({Vector3d(-10.0, -10.0, -5.0), Vector3d(10.0, 10.0, 5.0)});
                }}}),
      onPlate("no point is left", [](Spiral& s) { s.addKeepOut(square(0.0, 0.0, 30.0)); },
              {{"addKeepOut",
                [](Spiral& s) {
                  s.clearPart();
                  s.addKeepOut(square(0.0, 0.0, 2.0));
                }}}),
  });
}

TEST(SettingsRemedies, OfScansOnAMesh)
{
  const auto clear = [](Spiral& s) { s.clearPart(); };
  expectNoFaults({
      onMesh(
          "setViewPoint",
          [](Spiral& s) {
            s.setViewPoint({0.0, 0.0, 90.0});
          },
          [](Spiral& s) { s.clearViewPoint(); }, {{"setInputMesh", [](Spiral& s) { s.setInputCloud(plate(8.0)); }}}),
      onMesh(
          "setThinning", [](Spiral& s) { s.setThinning(0.9); }, [](Spiral& s) { s.setThinning(0.0); }),
      onMesh(
          "setOutlierRemoval", [](Spiral& s) { s.setOutlierRemoval(8); }, [](Spiral& s) { s.setOutlierRemoval(0); }),
      onMesh(
          "setCropBox",
          [](Spiral& s) {
            s.setCropBox({Vector3d(-9.0, -9.0, -9.0), Vector3d(9.0, 9.0, 9.0)});
          },
          clear),
      onMesh(
          "setCrop", [](Spiral& s) { s.setCrop(square(0.0, 0.0, 9.0)); }, clear),
      onMesh(
          "addKeepOut", [](Spiral& s) { s.addKeepOut(square(9.0, 0.0, 2.0)); }, clear),
      onMesh(
          "addRegion",
          [](Spiral& s) {
            s.addRegion({square(0.0, 0.0, 9.0), std::nullopt, ""});
          },
          clear),
      onMesh(
          "setInputNormals",
          [](Spiral& s) {
            const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
            normals->resize(plate(8.0)->size(), pcl::Normal(0.0f, 0.0f, 1.0f));
            s.setInputNormals(normals);
          },
          [](Spiral& s) { s.setInputNormals(nullptr); }),
      remediedJob<Spiral>("the mesh given is prepared already", saySpiral,
                          [](Spiral& s) {
                            s.setInputMesh(mesh());
                            setTool(s);
                            s.setFlipNormals(true);
                          },
                          {{"setFlipNormals", [](Spiral& s) { s.setFlipNormals(false); }},
                           {"MeshSettings::flip", [](Spiral& s) { s.setFlipNormals(false); }}}),
  });
}

} // namespace settings_remedies_test
