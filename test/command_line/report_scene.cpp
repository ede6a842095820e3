// SPDX-License-Identifier: BSD-3-Clause
// The scenes of reports in headless Chromium: a spiral over a scan, over a mesh and over two regions, drive passes, and verifications. A
// script (scene_check.js) uses each page as a reader does, and writes what it sees into the page. Without Chromium or without its WebGL
// the tests are skipped.
#include "cap_scan.h"
#include "run_program.h"
#include "support/ridges.h"
#include "two_domes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <sstream>

namespace report_scene_test {

namespace {

using namespace pcl_spiral;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/** Chromium of the PATH; empty: there is none. */
std::string
browser()
{
  std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const std::string file = folder + "/chromium"; ::access(file.c_str(), X_OK) == 0)
      return file;
  return {};
}

/** A run of Chromium with \p more options on a page of \p folder: the page after its scripts have run. No name of a host leads anywhere. */
RunResult
shown(const std::string& page, const ScratchFolder& folder, const Arguments& more = {})
{
  Arguments call{"120",
                 browser(),
                 "--headless",
                 "--no-sandbox",
                 "--user-data-dir=" + folder.path("chromium"),
                 "--use-gl=angle",
                 "--use-angle=swiftshader",
                 "--enable-unsafe-swiftshader",
                 "--host-resolver-rules=MAP * ~NOTFOUND",
                 "--enable-logging=stderr",
                 "--window-size=500,500",
                 "--virtual-time-budget=60000",
                 "--dump-dom",
                 "file://" + folder.path(page)};
  call.insert(call.end() - 1, more.begin(), more.end());
  return endOf(startProgram("/usr/bin/timeout", call, folder), folder);
}

/** The text of the element with \p id in \p page. */
std::string
textOf(const std::string& id, const std::string& page)
{
  const std::size_t at = page.find("id=\"" + id + "\">");
  if (at == std::string::npos)
    return {};
  const std::size_t begin = page.find('>', at) + 1;
  std::string text = page.substr(begin, page.find("</", begin) - begin);
  for (const auto& [entity, character] : {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&amp;", "&"}})
    for (std::size_t i = text.find(entity); i != std::string::npos; i = text.find(entity, i + 1))
      text.replace(i, std::string(entity).size(), character);
  return text;
}

/** Why no scene can be looked at here; empty: one can. */
std::string
lackOfScenes()
{
  if (browser().empty())
    return "no chromium in the PATH: scenes of reports are not looked at";
  if (!std::getenv("DISPLAY"))
    return "no display for the pictures of the .html";
  const ScratchFolder folder;
  writeText(folder.path("probe.html"), "<canvas></canvas><p id=\"found\"></p><script>document.getElementById('found').textContent = "
                                       "document.querySelector('canvas').getContext('webgl') ? 'yes' : 'no'</script>");
  const RunResult probe = shown("probe.html", folder);
  return textOf("found", probe.out) == "yes" ? "" : "chromium does not run here, or has no WebGL: " + probe.err.substr(0, 400);
}

class ReportScene : public ::testing::Test {
protected:
  void SetUp() override
  {
    static const std::string lack = lackOfScenes();
    if (!lack.empty())
      GTEST_SKIP() << lack;
  }

  void run(const char* program, const Arguments& arguments)
  {
    const RunResult result = endOf(startProgram(program, arguments, folder_), folder_);
    ASSERT_EQ(result.code, 0) << result.err;
  }

  /** What the script sees in \p page. */
  Json looked(const std::string& page)
  {
    std::string html = readText(folder_.path(page));
    const auto insert = [&](const std::string& before, const std::string& script) {
      const std::size_t at = html.find(before);
      ASSERT_NE(at, std::string::npos) << before;
      html.insert(at, "<script>" + script + "</script>");
    };
    const std::string folder = PCL_SPIRAL_MACHINES_DIR "/../../test/command_line/";
    insert("<title>", readText(folder + "scene_watch.js"));
    insert("</body>", readText(folder + "scene_check.js"));
    writeText(folder_.path("copy.html"), html);
    const RunResult result = shown("copy.html", folder_);
    EXPECT_EQ(result.err.find("CONSOLE"), std::string::npos) << result.err;
    const std::string text = textOf("scene-check", result.out);
    EXPECT_NE(text, "") << "the page did not come to its end\n" << result.err.substr(0, 2000);
    return text.empty() ? Json() : Json::parse(text);
  }

  /** What holds for each page. */
  Json expectScene(const std::string& page)
  {
    const Json seen = looked(page);
    if (seen.is_null())
      return seen;
    EXPECT_EQ(seen["errors"], Json::array());
    EXPECT_EQ(seen["requests"], Json::array()) << "the page needs no other file";
    EXPECT_TRUE(seen["ready"]);
    EXPECT_LE(seen["width"][0], seen["width"][1]) << "wider than the window";
    EXPECT_GT(seen["colours"], 100) << "a blank canvas";
    expectTool(seen);
    const double pixels = seen["pixels"];
    EXPECT_GT(seen["uncut"][0], 0.01 * pixels) << "the part before the cut";
    EXPECT_GT(seen["uncut"][0], 1.2 * seen["uncut"][1].get<double>());
    EXPECT_GT(seen["uncut"][1], 1.2 * seen["uncut"][2].get<double>());
    EXPECT_LT(seen["uncut"][2], 0.05 * seen["uncut"][0].get<double>()) << "not cut at the end";
    EXPECT_GT(seen["turned"], 0.02 * pixels) << "the pointer turns the part";
    for (std::size_t i = 1; i < seen["views"].size(); ++i)
      EXPECT_GT(seen["views"][i], 0.02 * pixels) << "view " << i;
    return seen;
  }

  /** The tool moves by slider and keys, and with it the figures. */
  void expectTool(const Json& seen)
  {
    const Json &early = seen["tool"][0], &late = seen["tool"][1];
    EXPECT_GT(early["count"], 30) << seen["tool"];
    EXPECT_GT(late["count"], 30) << seen["tool"];
    EXPECT_GT(std::hypot(early["x"].get<double>() - late["x"].get<double>(), early["y"].get<double>() - late["y"].get<double>()), 0.02)
        << seen["tool"];
    const Json& figures = seen["figures"];
    EXPECT_NE(figures[0], figures[1]);
    EXPECT_NE(figures.back().get<std::string>().find("Length 0.000 m"), std::string::npos) << figures;
    const std::vector<double> times = seen["times"]; // half, a move on, a turn on, a move back, Home
    EXPECT_EQ(times[0], 0.5);
    EXPECT_GT(times[1], times[0]);
    EXPECT_GT(times[2], times[1]);
    EXPECT_LT(times[3], times[2]);
    EXPECT_EQ(times[4], 0.0);
    EXPECT_EQ(seen["playing"], "Stop");
    EXPECT_EQ(seen["stopped"], "Play");
    EXPECT_GT(seen["played"], 0.0) << "time goes on while it plays";
  }

  /** Names of the colourings, each of them a picture of its own. */
  static std::vector<std::string> colouringsOf(const Json& seen)
  {
    std::vector<std::string> names;
    for (const Json& one : seen["colourings"]) {
      names.push_back(one[0]);
      EXPECT_GT(one[1], 60) << one;
    }
    return names;
  }

  ScratchFolder folder_;
};

const Arguments all_colours{"plain", "stock", "deviation"};
const std::string xyzac = std::string(PCL_SPIRAL_MACHINES_DIR) + "/xyzac.yaml";

} // namespace

TEST_F(ReportScene, OfASpiralPlaysItsProgramAndItsVerificationTheProgramAgain)
{
  writeText(folder_.path("cap.xyz"), capScan(6000));
  const Arguments tool{"--tool-radius", "3", "--scallop", "0.1"};
  Arguments call{"cap.xyz", "--verify", "-o", "a.html", "-o", "a.ngc", "--machine", xyzac};
  call.insert(call.end(), tool.begin(), tool.end());
  run(PCL_SPIRAL_TOOLPATH_PROGRAM, call);
  const Json seen = expectScene("a.html");
  EXPECT_EQ(colouringsOf(seen), all_colours);
  const std::string figures = seen["figures"][1];
  for (const char* words : {"Time ", " of ", "Length ", "Feed of the contact 1000 mm/min", "Turn ", "C ", "A "})
    EXPECT_NE(figures.find(words), std::string::npos) << words << " in " << figures;

  call = {"cap.xyz", "a.ngc", "--machine", xyzac, "-o", "v.html"};
  call.insert(call.end(), tool.begin(), tool.end());
  run(PCL_SPIRAL_VERIFY_PROGRAM, call);
  const Json judged = expectScene("v.html");
  EXPECT_EQ(colouringsOf(judged), all_colours);
  const std::string read = judged["figures"][1];
  for (const char* words : {"Line ", "Feed of the tip ", "C ", "A "})
    EXPECT_NE(read.find(words), std::string::npos) << words << " in " << read;
}

TEST_F(ReportScene, WithoutWebGLThePageSaysSoAndShowsThePictures)
{
  writeText(folder_.path("cap.xyz"), capScan(3000));
  run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"cap.xyz", "--tool-radius", "3", "--scallop", "0.1", "-o", "a.html", "-o", "a.csv"});
  std::string html = readText(folder_.path("a.html"));
  html.insert(html.find("</body>"), "<script>onload = () => { const found = document.createElement('pre'), images = [...document.images];"
                                    "found.id = 'found'; found.textContent = document.querySelector('#scene .message').innerText + '|' +"
                                    "images.filter(one => one.naturalWidth > 100 && one.clientWidth > 100).length + '|' + "
                                    "document.querySelector('#scene canvas').clientHeight; document.body.append(found); }</script>");
  writeText(folder_.path("copy.html"), html);
  const RunResult result = shown("copy.html", folder_, {"--disable-3d-apis"});
  const std::string found = textOf("found", result.out);
  EXPECT_EQ(found.find("This browser shows no 3-D (WebGL); the pictures below show the same part.|"), 0U) << found;
  EXPECT_EQ(found.substr(found.rfind('|')), "|0") << "an empty canvas";
  EXPECT_GT(std::atoi(found.substr(found.find('|') + 1).c_str()), 0) << found;
}

TEST_F(ReportScene, OfAMeshShowsItsFaces)
{
  std::ostringstream text;
  constexpr int cells = 6; // large faces: the scene cuts them into pieces
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      text << "v " << 5 * i << ' ' << 5 * j << ' ' << 0.02 * (i - 3) * (i - 3) + 0.03 * (j - 3) * (j - 3) << '\n';
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const int a = i * (cells + 1) + j + 1, b = a + cells + 1;
      text << "f " << a << ' ' << b << ' ' << b + 1 << "\nf " << a << ' ' << b + 1 << ' ' << a + 1 << '\n';
    }
  writeText(folder_.path("hollow.obj"), text.str());
  run(PCL_SPIRAL_TOOLPATH_PROGRAM,
      {"hollow.obj", "--mesh", "--tool-radius", "3", "--scallop", "0.05", "--verify", "-o", "a.html", "-o", "a.csv"});
  EXPECT_EQ(colouringsOf(expectScene("a.html")), all_colours);
}

TEST_F(ReportScene, OfTwoRegionsShowsBoth)
{
  std::ostringstream all;
  for (const Eigen::Vector3d& p : two_domes::twoDomes())
    all << p.transpose() << '\n';
  writeText(folder_.path("scan.xyz"), all.str());
  run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"scan.xyz", "--part-at=-75,0,4", "--part-at=85,10,7", "--tool-radius", "4", "--scallop", "0.1",
                                    "--verify", "--rapid-height", "10", "-o", "a.html", "-o", "a.ngc", "--machine", xyzac});
  const Json seen = expectScene("a.html");
  EXPECT_EQ(colouringsOf(seen), all_colours);
  EXPECT_NE(seen["colourings"][0][2].get<std::string>().find("through the air"), std::string::npos);
}

TEST_F(ReportScene, OfDrivePassesShowsCutterAndHolder)
{
  writeText(folder_.path("cap.xyz"), capScan(6000));
  run(PCL_SPIRAL_DRIVE_PROGRAM, {"cap.xyz", "--tool-radius", "4", "--corner-radius", "1", "--flank-length", "12", "--holder", "4,30/12,20",
                                 "--step-over", "4", "--tolerance", "0.1", "-o", "a.html", "-o", "a.csv"});
  const Json seen = expectScene("a.html");
  EXPECT_EQ(colouringsOf(seen), Arguments{"plain"}) << "not judged";
  EXPECT_NE(seen["figures"][1].get<std::string>().find("Pass "), std::string::npos) << seen["figures"][1];
}

TEST_F(ReportScene, OfARidgeShowsItsRows)
{
  const test::ExactRidge die = test::dieRidge();
  const auto lines = [](const Polyline& points) {
    std::ostringstream text;
    for (const Eigen::Vector3d& p : points)
      text << p.transpose() << '\n';
    return text.str();
  };
  writeText(folder_.path("rail.txt"), lines(die.railPoints(300)));
  writeText(folder_.path("generator.txt"), lines(die.generatorPoints(0.37, 100)));
  run(PCL_SPIRAL_RIDGE_PROGRAM, {"rail.txt", "generator.txt", "--spot", "4", "--stand-off", "10", "-o", "a.html", "-o", "a.6d"});
  EXPECT_EQ(colouringsOf(expectScene("a.html")), Arguments{"plain"});
}

} // namespace report_scene_test
