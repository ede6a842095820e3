// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_view from outside: refused command lines, and its message without a display.
#include "run_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include <X11/Xlib.h>

namespace view_test {

namespace {

using Arguments = std::vector<std::string>;

/** A window of this name. */
class NamedWindow {
public:
  explicit NamedWindow(std::string name) : display_(XOpenDisplay(nullptr)), name_(std::move(name)) {}
  ~NamedWindow()
  {
    if (display_)
      XCloseDisplay(display_);
  }
  NamedWindow(const NamedWindow&) = delete;
  NamedWindow& operator=(const NamedWindow&) = delete;

  /** Waits for it, at most a minute. */
  bool appears()
  {
    for (int i = 0; i < 600 && window_ == 0; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      window_ = find();
    }
    return window_ != 0;
  }

private:
  Window find()
  {
    Window root = 0, parent = 0, *children = nullptr, found = 0;
    unsigned int count = 0;
    if (!display_ || !XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count))
      return 0;
    for (unsigned int i = 0; i < count; ++i) {
      char* name = nullptr;
      if (XFetchName(display_, children[i], &name) && name_ == name)
        found = children[i];
      if (name)
        XFree(name);
    }
    if (children)
      XFree(children);
    return found;
  }
  Display* display_;
  std::string name_;
  Window window_ = 0;
};

class View : public ::testing::Test {
protected:
  void SetUp() override
  {
    std::ostringstream text; // a flat disc
    for (int i = 0; i < 3000; ++i) {
      const double r = 20.0 * std::sqrt((i + 0.5) / 3000.0), angle = 2.39996322972865 * i;
      text << r * std::cos(angle) << ' ' << r * std::sin(angle) << " 0\n";
    }
    writeText(folder_.path("disc.xyz"), text.str());
  }
  RunResult view(const Arguments& arguments) { return endOf(startProgram(PCL_SPIRAL_VIEW_PROGRAM, arguments, folder_), folder_); }
  ScratchFolder folder_;
};

TEST_F(View, WrongCallsAreRefused)
{
  const std::vector<std::pair<Arguments, std::string>> calls{
      {{}, "0 files are given"},
      {{"disc.ply", "--mesh"}, "a mesh is shown with a path"},
      {{"disc.xyz", "--tool-radius", "4"}, "belong to a path"},
      {{"disc.xyz", "a.csv", "--part-at", "0,0,0", "--part-at", "9,0,0"}, "the window shows one region"},
      {{"disc.xyz", "a.csv", "b.csv"}, "3 files are given"},
      {{"disc.xyz", "a.csv", "--tool-radius", "x"}, "--tool-radius x"},
      {{"disc.xyz", "a.csv", "--tool-radius", "0"}, "--tool-radius must be above 0"},
      {{"disc.xyz", "a.csv", "--units", "yard"}, "--units yard"},
      {{"disc.xyz", "a.csv", "--crease-angle", "20"}, "--crease-angle belongs to meshes"},
      {{"disc.ply", "a.csv", "--mesh", "--view-point", "0,0,9"}, "--view-point belongs to scans"},
      {{"disc.xyz", "a.csv", "--no-such"}, "no-such"}};
  for (const auto& [arguments, message] : calls) {
    const RunResult result = view(arguments);
    EXPECT_EQ(result.code, 2) << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  }
  const RunResult help = view({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_NE(help.out.find("--tool-radius"), std::string::npos);
}

TEST_F(View, WithoutADisplayTheWayToOneIsNamed)
{
  const char* const before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  ::unsetenv("DISPLAY");
  RunResult result = view({"disc.xyz", "disc.csv"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.err.find("DISPLAY is not set"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("xvfb-run -a"), std::string::npos) << result.err;
  ::setenv("DISPLAY", ":9876", 1);
  result = view({"disc.xyz", "disc.csv"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.err.find("':9876' cannot be opened"), std::string::npos) << result.err;
  if (before)
    ::setenv("DISPLAY", kept.c_str(), 1);
  else
    ::unsetenv("DISPLAY");
}

TEST_F(View, TheWindowOpensAndClosesOnRequest)
{
  if (!std::getenv("DISPLAY"))
    GTEST_SKIP() << "no display here";
  const RunResult missing = view({"disc.xyz", "none.csv"});
  EXPECT_EQ(missing.code, 1);
  EXPECT_NE(missing.err.find("none.csv"), std::string::npos) << missing.err;
  const RunResult made =
      endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, {"disc.xyz", "--tool-radius", "3", "--scallop", "0.05", "-o", "disc.csv"}, folder_),
            folder_);
  ASSERT_EQ(made.code, 0) << made.err;
  const pid_t process = startProgram(PCL_SPIRAL_VIEW_PROGRAM, {"disc.xyz", "disc.csv"}, folder_);
  EXPECT_TRUE(NamedWindow("pcl_spiral: disc.csv").appears());
  ::kill(process, SIGTERM);
  const RunResult ended = endOf(process, folder_);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
}

TEST_F(View, AMeshIsShownByItsFaces)
{
  if (!std::getenv("DISPLAY"))
    GTEST_SKIP() << "no display here";
  const RunResult points = view({"disc.xyz", "plate.csv", "--mesh"});
  EXPECT_EQ(points.code, 1);
  EXPECT_NE(points.err.find("disc.xyz"), std::string::npos) << points.err;
  writeText(folder_.path("bare.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  const RunResult bare = view({"bare.obj", "plate.csv", "--mesh"});
  EXPECT_EQ(bare.code, 1);
  EXPECT_NE(bare.err.find("face"), std::string::npos) << bare.err;
  writeText(folder_.path("plate.obj"), "v -20 -20 0\nv 20 -20 0\nv 20 20 0\nv -20 20 0\nf 1 2 3 4\n");
  const RunResult made =
      endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, {"disc.xyz", "--tool-radius", "3", "--scallop", "0.05", "-o", "plate.csv"}, folder_),
            folder_);
  ASSERT_EQ(made.code, 0) << made.err;
  const pid_t process = startProgram(PCL_SPIRAL_VIEW_PROGRAM, {"plate.obj", "plate.csv", "--mesh", "--tool-radius", "3"}, folder_);
  EXPECT_TRUE(NamedWindow("pcl_spiral: plate.csv").appears());
  ::kill(process, SIGTERM);
  const RunResult ended = endOf(process, folder_);
  EXPECT_EQ(ended.code, 0) << ended.err;
}

} // namespace

} // namespace view_test
