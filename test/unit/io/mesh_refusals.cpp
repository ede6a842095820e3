// SPDX-License-Identifier: BSD-3-Clause
// A clear error for each broken mesh file; its scan can still be read.
#include <pcl_spiral/io/mesh_reader.h>

#include "support/mesh_files.h"

#include <cmath>

namespace mesh_refusals_test {

using namespace pcl_spiral;

using MeshRefusals = MeshFiles;

TEST_F(MeshRefusals, SaysWhatIsWrongWithTheFile)
{
  EXPECT_NE(problem(folder_.path("missing.stl")).find("no such file"), std::string::npos);
  std::filesystem::create_directory(folder_.path("folder.obj"));
  EXPECT_NE(problem(folder_.path("folder.obj")).find("is a folder"), std::string::npos);
  for (const std::string& extension : meshExtensions())
    expectProblem("empty" + extension, "", "is empty (0 bytes)");
  expectProblem("a.xyz", "1 2 3\n",
                "extension '.xyz' is not known for a mesh; use .stl .obj or .ply, or read points as a scan (readCloud)");
}

TEST_F(MeshRefusals, SaysThatThereAreNoFaces)
{
  const std::string words = "holds no faces, only 4 points; give it as a scan (readCloud)";
  expectProblem("a.obj", obj_corners, words);
  expectProblem("b.ply", ascii + ply_vertices + "end_header\n" + ply_rows, words);
  expectProblem("c.ply", ascii + ply_vertices + "element face 0\nproperty list uchar int vertex_indices\nend_header\n" + ply_rows, words);
  expectProblem("d.stl", "solid a\nendsolid a\n", "holds no triangles");
  expectProblem("e.obj", "f 1 2 3\n", "holds no vertices");
}

TEST_F(MeshRefusals, SaysWhichFaceIsBadInObj)
{
  expectProblem("a.obj", obj_corners + "f 1 3 2\nf 1 2 5\n", "face 2 (line 6) names vertex 5, but the file has vertices 1 to 4");
  expectProblem("b.obj", obj_corners + "f 1 3 0\n", "line 5: '0' names no vertex; a face needs numbers from 1");
  expectProblem("c.obj", obj_corners + "f 1 3 -5/1\n", "line 5: '-5/1' counts back beyond the 4 vertices before it");
  expectProblem("d.obj", obj_corners + "f 1 3 x\n", "line 5: 'x' names no vertex");
  expectProblem("e.obj", obj_corners + "f 1 3 99999999999999999999\n", "line 5: '99999999999999999999' names no vertex");
  expectProblem("f.obj", obj_corners + "f 1 3 2\nf 1 \\\n3\n", "face 2 (line 6) has 2 corners, but a face needs three");
  expectProblem("g.obj", obj_corners + "f\n", "face 1 (line 5) has 0 corners");
  expectProblem("h.obj", "v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n", "face 1 (line 4): its vertex 2 is at (1, 0, inf), which is not a place");
  expectProblem("i.obj", "v 0 0 0\nv 1 0 1e39\nv 0 1 0\nf 1 2 3\n",
                "vertex 2 is at (1, 0, inf)"); // beyond single precision
}

TEST_F(MeshRefusals, SaysWhichFaceIsBadInPly)
{
  const std::string start = ascii + ply_vertices + ply_faces + "end_header\n" + ply_rows;
  expectProblem("a.ply", start + "3 0 2 1\n3 0 1 4\n", "face 2 (line 15) names vertex 4, but the file has vertices 0 to 3");
  expectProblem("b.ply", start + "3 0 2 1\n3 0 1 -1\n", "face 2 (line 15) names vertex -1");
  expectProblem("c.ply", start + "3 0 2 1\n3 0 1 1.5\n", "line 15: 1.5 names no vertex");
  expectProblem("d.ply", start + "3 0 2 1\n3 0 1 nan\n", "line 15: nan names no vertex");
  expectProblem("e.ply", start + "3 0 2 1\n3 0 x 1\n", "line 15: 'x' is not a number");
  expectProblem("f.ply", start + "3 0 2 1\n3 0 1\n", "line 15: a list of 3 corners, but the line has 2; is the file cut off?");
  expectProblem("g.ply", start + "3 0 2 1\n", "in face 2 of 2; copy or export it again");
  expectProblem("h.ply", start + "2 0 2\n3 0 1 3\n", "face 1 (line 14) has 2 corners");
  expectProblem("i.ply",
                ascii + "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n" + ply_faces +
                    "end_header\nnan 1 2\n3 0 0 0\n3 0 0 0\n",
                "face 1 (line 11): its vertex 0 is at (nan, 1, 2)");
  expectProblem("j.ply", ascii + ply_vertices + "element face 1\nproperty list uchar int corners\nend_header\n" + ply_rows + "3 0 1 2\n",
                "has faces without a list 'vertex_indices' or 'vertex_index'");
  expectProblem("k.ply",
                ascii + ply_vertices + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + ply_rows + "4 0 1 2 3\n",
                "holds triangle strips (element tristrips), which cannot be read");
  const std::string binary = "ply\nformat binary_little_endian 1.0\n";
  expectProblem("l.ply", binary + "element face 999999999999999\nproperty list uint double vertex_indices\nend_header\n\xff\xff\xff\xff",
                "cut off");
  expectProblem("m.ply", binary + "element face 1\nproperty list float int vertex_indices\nend_header\n" + bytesOf(-1.0f, false),
                "a list of -1 entries");
}

TEST_F(MeshRefusals, SaysWhichFacetIsBadInStl)
{
  const std::string bytes = binaryStl(two_faces);
  expectProblem("a.stl", bytes.substr(0, 150), "is cut off at byte 150: its 2 triangles need 184 bytes");
  std::string broken = bytes;
  broken.replace(84 + 50 + 12 + 24, 4, bytesOf(std::nanf(""), false)); // the last corner of the second
  expectProblem("b.stl", broken, "face 2 (byte 134): its vertex 4 is at (nan, 0, 10.5), which is not a place");
  expectProblem("c.stl", "solid a\n" + facet("vertex 0 0 0\nvertex 1 0 0\n") + "endsolid\n",
                "line 4: a facet of 2 corners begins here, but STL has triangles");
  expectProblem("d.stl", "solid a\n" + facet("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n") + "endsolid\n",
                "line 4: a facet of 4 corners");
  expectProblem("e.stl", "solid a\n" + facet("vertex 0 0 0\nvertex 1 0 0\nvertex inf 1 0\n") + "endsolid\n",
                "face 1 (line 4): its vertex 3 is at (inf, 1, 0)");
  expectProblem("f.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "'endsolid' is missing");
}

TEST_F(MeshRefusals, BadFacesDoNotKeepAScanFromBeingRead)
{
  const std::string start = ascii + ply_vertices + ply_faces + "end_header\n" + ply_rows;
  for (const std::string& file :
       {text("a.ply", start + "3 0 2 9\n3 x\n"),
        text("b.ply", ascii + ply_vertices +
                          "element tristrips 1\n"
                          "property list int int vertex_indices\nend_header\n" +
                          ply_rows + "2 0\n"),
        text("c.obj", obj_corners + "f 0 x\nf\nf 9 9 9 \\\n"),
        text("d.stl", "solid\n" + facet("vertex 0 0 0\nvertex 10 0 0\nvertex 0 10 0\nvertex 0 0 10.5\n") + "endsolid\n")}) {
    EXPECT_NE(problem(file), "") << file;
    const Scan scan = readCloud(file);
    ASSERT_EQ(scan.cloud->size(), corners.size()) << file;
    for (std::size_t i = 0; i < corners.size(); ++i)
      EXPECT_EQ((*scan.cloud)[i].getVector3fMap(), corners[i]) << file;
  }
}

} // namespace mesh_refusals_test
