// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_verify from outside: figures, planted faults, limits, exit codes.
#include <pcl_spiral/io/toolpath_reader.h>

#include "cap_scan.h"
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>

namespace verify_test {

namespace {

using Arguments = std::vector<std::string>;

class Verify : public ::testing::Test {
protected:
  static constexpr double radius = 3.0, scallop = 0.02, chord_error = 0.005;

  /** The scan and its path, made once. */
  static void SetUpTestSuite()
  {
    made_ = std::make_unique<ScratchFolder>();
    writeText(made_->path("cap.xyz"), capScan(8000));
    const RunResult made = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                                              {"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "cap.csv", "-o", "cap.pcd", "-o",
                                               "cap.ply", "-o", "cap.vtp"},
                                              *made_),
                                 *made_);
    ASSERT_EQ(made.code, 0) << made.err;
  }
  static void TearDownTestSuite() { made_.reset(); }
  void SetUp() override { std::filesystem::copy(made_->root(), folder_.root()); }

  RunResult verify(Arguments arguments)
  {
    arguments.insert(arguments.begin(), "cap.xyz");
    arguments.insert(arguments.end(), {"--tool-radius", "3", "--scallop", "0.02"});
    return endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
  }

  nlohmann::json figures(const std::string& path, Arguments arguments = {})
  {
    arguments.insert(arguments.begin(), {path, "-o", "figures.json"});
    last_ = verify(arguments);
    const std::string text = readText(folder_.path("figures.json"));
    return text.empty() ? nlohmann::json() : nlohmann::json::parse(text)["paths"][0];
  }

  /** An array of a .vtp, read by VTK. */
  std::vector<double> pointData(const std::string& file, const char* name)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(folder_.path(file).c_str());
    reader->Update();
    vtkDataArray* const array = reader->GetOutput()->GetPointData()->GetArray(name);
    std::vector<double> values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
      values.push_back(array->GetComponent(i, 0));
    return values;
  }

  /** cap.csv with its rows changed by \p change(fields of a row, row number); rows that it empties are removed. */
  template <typename Change>
  void spoil(const Change& change)
  {
    std::istringstream in(readText(folder_.path("cap.csv")));
    std::ostringstream out;
    std::string line;
    std::getline(in, line);
    out << line << '\n';
    for (std::size_t row = 0; std::getline(in, line); ++row) {
      std::vector<double> fields;
      std::istringstream words(line);
      for (std::string word; std::getline(words, word, ',');)
        fields.push_back(std::stod(word));
      change(fields, row);
      for (std::size_t f = 0; f < fields.size(); ++f)
        out << (f > 0 ? "," : "") << std::fixed << std::setprecision(9) << fields[f];
      out << (fields.empty() ? "" : "\n");
    }
    writeText(folder_.path("spoilt.csv"), out.str());
  }

  static inline std::unique_ptr<ScratchFolder> made_;
  ScratchFolder folder_;
  RunResult last_;
};

TEST_F(Verify, AGoodPathKeepsItsLimits)
{
  const auto path = figures("cap.csv", {"--max-gouge", "0.008", "--max-scallop", "0.026", "--max-deviation", "0.003", "--max-uncut", "0"});
  EXPECT_EQ(last_.code, 0) << last_.out << last_.err;
  EXPECT_GT(path["material"]["scallop"]["p50"], 0.5 * scallop);
  EXPECT_LE(path["material"]["scallop"]["p99.9"], 1.02 * scallop + chord_error);
  EXPECT_EQ(path["material"]["stock"]["uncut_share"], 0.0);
  EXPECT_GT(path["material"]["efficiency"], 0.9);
  EXPECT_LE(path["material"]["efficiency"], 1.02);
  EXPECT_NE(last_.out.find("efficiency"), std::string::npos);
}

TEST_F(Verify, ReadsBackEveryFormat)
{
  const auto csv = figures("cap.csv");
  for (const std::string name : {"cap.pcd", "cap.ply", "cap.vtp"}) {
    const auto other = figures(name);
    ASSERT_FALSE(other.is_null()) << name << ": " << last_.err;
    EXPECT_EQ(other["deviation"]["points"], csv["deviation"]["points"]) << name;
    EXPECT_NEAR(other["material"]["scallop"]["p99"], csv["material"]["scallop"]["p99"], 1e-4) << name;
    EXPECT_NEAR(other["motion"]["length"], csv["motion"]["length"], 0.1) << name;
  }
}

TEST_F(Verify, AMeshTakesTheScansPlace)
{
  const auto height = [](double x, double y) { return 0.5 * std::cos(0.2 * x) * std::cos(0.2 * y); };
  constexpr int cells = 20;
  std::ostringstream obj, csv;
  const auto place = [](int i) { return 1.0 * i - 10.0; };
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      obj << "v " << place(i) << ' ' << place(j) << ' ' << height(place(i), place(j)) << '\n';
  writeText(folder_.path("points.obj"), obj.str());
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i + 1;
      obj << "f " << a << ' ' << a + 1 << ' ' << a + cells + 2 << ' ' << a + cells + 1 << '\n';
    }
  writeText(folder_.path("part.obj"), obj.str());
  csv << "turn,arc_length,cc_x,cc_y,cc_z,normal_x,normal_y,normal_z,tip_x,tip_y,tip_z,axis_x,axis_y,axis_z,feed\n" << std::setprecision(10);
  double length = 0.0;
  for (int row = 0; row <= 40; ++row)
    for (int i = 0; i <= 80; ++i) {
      const double x = (row % 2 ? -1.0 : 1.0) * (0.25 * i - 10.0), y = 0.5 * row - 10.0, d = 1e-5;
      const double nx = -(height(x + d, y) - height(x - d, y)) / (2 * d), ny = -(height(x, y + d) - height(x, y - d)) / (2 * d);
      length += i > 0 ? 0.25 : 0.0;                                              // flat enough for this sum
      const double steep = std::sqrt(nx * nx + ny * ny + 1.0), z = height(x, y); // a ball of 3 mm touches at the contact
      csv << row << ',' << length << ',' << x << ',' << y << ',' << z << ',' << nx / steep << ',' << ny / steep << ',' << 1.0 / steep << ','
          << x + 3.0 * nx / steep << ',' << y + 3.0 * ny / steep << ',' << z + 3.0 / steep - 3.0 << ",0,0,1,1000\n";
    }
  writeText(folder_.path("rows.csv"), csv.str());
  const auto run = [&](Arguments arguments) {
    arguments.insert(arguments.end(), {"--tool-radius", "3", "--scallop", "0.02"});
    return endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
  };
  const RunResult good = run({"part.obj", "rows.csv", "--mesh", "--max-gouge", "0.02", "--max-deviation", "0.002", "--max-uncut", "0", "-o",
                              "mesh.json", "-o", "mesh.html", "-o", "mesh.png"});
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  EXPECT_NE(good.out.find("samples of the mesh"), std::string::npos) << good.out;
  EXPECT_NE(good.out.find("40 between passes"), std::string::npos) << good.out;
  EXPECT_EQ(good.err, "");
  const auto json = nlohmann::json::parse(readText(folder_.path("mesh.json")));
  EXPECT_EQ(json["input"]["mesh"]["faces"], 2 * cells * cells);
  EXPECT_EQ(json["input"]["mesh"]["crease_edges"], 0);
  EXPECT_EQ(json["paths"][0]["motion"]["lifts"], 40);
  EXPECT_NE(readText(folder_.path("mesh.html")).find("Faces judged"), std::string::npos);
  EXPECT_GT(readText(folder_.path("mesh.png")).size(), 10000u);

  const auto fails = [&](const Arguments& arguments, int code, const std::string& words) {
    const RunResult bad = run(arguments);
    EXPECT_EQ(bad.code, code) << words << ": " << bad.out << bad.err;
    EXPECT_NE(bad.err.find(words), std::string::npos) << words << ": " << bad.err;
  };
  fails({"points.obj", "rows.csv", "--mesh"}, 1, "faces");
  fails({"missing.stl", "rows.csv", "--mesh"}, 1, "missing.stl");
  fails({"part.obj", "rows.csv", "--mesh", "--units", "m"}, 1, "another unit");
  fails({"part.obj", "rows.csv", "--crease-angle", "20"}, 2, "--mesh");
  fails({"part.obj", "rows.csv", "--mesh", "--crease-angle", "0"}, 2, "--crease-angle");
  fails({"part.obj", "rows.csv", "--mesh", "--view-point", "0,0,100"}, 2, "--view-point");
  for (const Arguments& limit : {Arguments{"--max-gouge", "0.02"}, Arguments{}}) {
    Arguments arguments{"part.obj", "rows.csv", "--mesh", "--flip-normals"};
    arguments.insert(arguments.end(), limit.begin(), limit.end());
    const RunResult flipped = run(arguments);
    EXPECT_EQ(flipped.code, 1) << limit.size();
    EXPECT_NE(flipped.out.find("normal that points into the material"), std::string::npos) << flipped.out;
  }
}

TEST_F(Verify, FindsAGougeAndWhereItIs)
{
  constexpr std::size_t place = 2000;
  constexpr double deep = 0.05;
  spoil([&](std::vector<double>& f, std::size_t row) {
    if (row == place)
      for (int axis = 0; axis < 3; ++axis)
        f[2 + axis] -= deep * f[5 + axis];
  });
  const auto path = figures("spoilt.csv", {"--max-gouge", "0.01"});
  EXPECT_EQ(last_.code, 1);
  EXPECT_NE(last_.out.find("--max-gouge 0.01 is broken"), std::string::npos) << last_.out;
  EXPECT_NEAR(path["material"]["gouge"]["value"], deep, 0.003);
  EXPECT_NEAR(path["material"]["gouge"]["index"].get<double>(), place, 1.0);
  EXPECT_NEAR(path["deviation"]["max"]["value"], -deep, 0.001);
  EXPECT_EQ(path["deviation"]["max"]["index"], place);
  const RunResult quiet = verify({"spoilt.csv", "--max-gouge", "0.01", "--max-deviation", "0.02", "--quiet"});
  EXPECT_EQ(quiet.code, 1);
  EXPECT_EQ(quiet.out, "");
  EXPECT_NE(quiet.err.find("pcl_spiral_verify: spoilt.csv: --max-gouge 0.01 is broken: 0.0"), std::string::npos) << quiet.err;
  EXPECT_NE(quiet.err.find("pcl_spiral_verify: spoilt.csv: --max-deviation 0.02 is broken: 0.0"), std::string::npos) << quiet.err;
  EXPECT_EQ(quiet.err.find("warning"), std::string::npos) << quiet.err;
}

TEST_F(Verify, FindsTipsAndAxesThatTheContactsDoNotHave)
{
  constexpr std::size_t place = 2000;
  spoil([&](std::vector<double>& f, std::size_t row) { f[8] += row == place ? 0.05 : 0.0; });
  auto path = figures("spoilt.csv", {"--max-gouge", "0.1"});
  EXPECT_EQ(last_.code, 1);
  EXPECT_EQ(path["tips_off"], 1);
  EXPECT_EQ(path["tip_error"]["index"], place);
  EXPECT_NEAR(path["tip_error"]["value"], 0.05, 0.001);
  EXPECT_NE(last_.err.find("at path point 2000"), std::string::npos) << last_.err;
  spoil([&](std::vector<double>& f, std::size_t row) {
    for (int axis = 0; row == place && axis < 3; ++axis)
      f[11 + axis] *= -1.0;
  });
  path = figures("spoilt.csv", {"--max-gouge", "0.1"});
  EXPECT_EQ(last_.code, 1);
  EXPECT_EQ(path["deviation"]["inward_axes"], 1);
  EXPECT_NE(last_.out.find("tool axis that points into the material"), std::string::npos) << last_.out;
}

TEST_F(Verify, TheRimKeepsTheLimitsToo)
{
  std::size_t rows = 0;
  double last_turn = 0.0;
  spoil([&](std::vector<double>& f, std::size_t) {
    ++rows;
    last_turn = f[0];
  });
  spoil([&](std::vector<double>& f, std::size_t) {
    if (f[0] > last_turn - 1.5) // the turn along the rim and half of the turn before it
      f.clear();
  });
  const auto path = figures("spoilt.csv", {"--max-scallop", "0.03"});
  EXPECT_EQ(last_.code, 1);
  EXPECT_GT(path["material"]["rim_band"]["max"]["value"], 0.03);
  EXPECT_NE(last_.out.find("left at the rim"), std::string::npos) << last_.out;
}

TEST_F(Verify, VtpCarriesTheDeviationOfEachPoint)
{
  constexpr std::size_t place = 2000;
  spoil([&](std::vector<double>& f, std::size_t row) {
    f[14] = row < place ? 700.0 : 900.0; // its feed
    if (row == place)
      for (int axis = 0; axis < 3; ++axis)
        for (int column : {2, 8}) // contact and tip
          f[column + axis] += 0.02 * f[5 + axis];
  });
  const auto path = figures("spoilt.csv", {"-o", "judged.vtp"});
  ASSERT_EQ(last_.code, 0) << last_.err;
  const std::vector<double> deviation = pointData("judged.vtp", "Deviation");
  ASSERT_EQ(deviation.size(), path["deviation"]["points"].get<std::size_t>());
  EXPECT_EQ(path["deviation"]["max"]["index"], place);
  EXPECT_NEAR(deviation[place], 0.02, 0.001);
  EXPECT_NEAR(deviation[place], path["deviation"]["max"]["value"].get<double>(), 1e-6);
  const auto unmeasured = std::count_if(deviation.begin(), deviation.end(), [](double v) { return std::isnan(v); });
  EXPECT_EQ(unmeasured, path["deviation"]["unmeasured"].get<long>());
  const std::vector<double> feed = pointData("judged.vtp", "Feed");
  ASSERT_EQ(feed.size(), deviation.size());
  EXPECT_EQ(feed[place - 1], 700.0);
  EXPECT_EQ(feed[place], 900.0);
  // A path without feeds gives a file without them, which can still be read.
  ASSERT_EQ(verify({"cap.pcd", "-o", "of_pcd.vtp"}).code, 0);
  EXPECT_TRUE(pointData("of_pcd.vtp", "Feed").empty());
  const auto read = pcl_spiral::readToolpath(folder_.path("of_pcd.vtp"));
  EXPECT_EQ(read.path.size(), deviation.size());
  EXPECT_TRUE(read.feed.empty());
}

TEST_F(Verify, FindsAMissingTurnAndThePointsBesideIt)
{
  double gone = 0.0;
  spoil([&](std::vector<double>& f, std::size_t) {
    if (f[0] >= 20.0 && f[0] < 21.0) {
      gone = f[1];
      f.clear();
    }
  });
  ASSERT_GT(gone, 0.0);
  const auto path = figures("spoilt.csv", {"--max-scallop", "0.03", "-o", "judged.vtp"});
  EXPECT_EQ(last_.code, 1);
  // Twice the pitch leaves four times the height.
  const double highest = path["material"]["scallop"]["max"]["value"];
  EXPECT_NEAR(highest, 4.0 * scallop, 0.15 * 4.0 * scallop);

  const std::vector<double> ridges = pointData("judged.vtp", "Scallop"), turns = pointData("judged.vtp", "Turn");
  ASSERT_EQ(ridges.size(), path["deviation"]["points"].get<std::size_t>());
  double beside = 0.0, apart = 0.0;
  std::size_t known = 0;
  for (std::size_t i = 0; i < ridges.size(); ++i) {
    if (std::isnan(ridges[i]))
      continue;
    ++known;
    // The ridge of a point may be a step-over from it, and the point a spacing of the scan from the path.
    double& larger = std::abs(turns[i] - 20.5) < 3.0 ? beside : apart;
    larger = std::max(larger, ridges[i]);
  }
  EXPECT_GT(known, 3 * ridges.size() / 4) << "all but the rim's band";
  EXPECT_LT(apart, 1.3 * scallop);
  EXPECT_GT(beside, 0.9 * highest);
  EXPECT_LE(beside, highest + 1e-6) << "the highest of all is sought between the points, too";
}

TEST_F(Verify, SaysWhichLimitsAScanCannotShow)
{
  writeText(folder_.path("noisy.xyz"), capScan(4000, 0.05));
  const auto run = [&](const char* program, Arguments arguments) {
    arguments.insert(arguments.begin(), "noisy.xyz");
    arguments.insert(arguments.end(), {"--tool-radius", "3", "--scallop", "0.02"});
    last_ = endOf(startProgram(program, arguments, folder_), folder_);
  };
  run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"-o", "noisy.csv"});
  std::istringstream rows(readText(folder_.path("noisy.csv")));
  std::string inner, row;
  for (int i = 0; i < 600 && std::getline(rows, row); ++i) // few points: small extremes of the same noise
    inner += row + "\n";
  writeText(folder_.path("inner.csv"), inner);
  run(PCL_SPIRAL_VERIFY_PROGRAM, {"inner.csv", "-o", "noisy.json"});
  const auto free = nlohmann::json::parse(readText(folder_.path("noisy.json")))["paths"][0];
  const double kept = std::abs(free["deviation"]["max"]["value"].get<double>());
  const double shown = 3.0 * free["fit_noise"].get<double>();
  ASSERT_LT(kept, shown);
  EXPECT_TRUE(free["unproven_limits"].empty());
  const std::string limit = std::to_string(0.5 * (kept + shown));
  run(PCL_SPIRAL_VERIFY_PROGRAM, {"inner.csv", "-o", "noisy.json", "--max-deviation", limit, "--max-gouge", "0.5"});
  EXPECT_EQ(last_.code, 0) << last_.out;
  const auto json = nlohmann::json::parse(readText(folder_.path("noisy.json")));
  EXPECT_NEAR(json["limits"]["max_deviation"], std::stod(limit), 1e-12);
  EXPECT_TRUE(json["limits"]["max_uncut_percent"].is_null());
  ASSERT_EQ(json["paths"][0]["unproven_limits"].size(), 1U) << last_.out;
  EXPECT_NE(last_.out.find("this scan cannot show that it holds"), std::string::npos) << last_.out;
}

TEST_F(Verify, MessagesNameNoOptionThatThereIsNot)
{
  std::istringstream cap(readText(folder_.path("cap.xyz")));
  std::ostringstream two;
  two << cap.str();
  for (double x, y, z; cap >> x >> y >> z;)
    two << 0.5 * x + 120.0 << ' ' << 0.5 * y << ' ' << z + 5.0 << '\n';
  writeText(folder_.path("cap.xyz"), two.str());
  last_ = verify({"cap.csv"});
  EXPECT_NE(last_.err.find("keep only the largest one, or only the one"), std::string::npos) << last_.err;
  for (const char* word : {"--largest", "setLargestPart"})
    EXPECT_EQ((last_.err + last_.out).find(word), std::string::npos) << last_.err;
}

TEST_F(Verify, WrongCallsAndDataAreRefused)
{
  const auto code = [&](const Arguments& arguments) {
    last_ = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
    return last_.code;
  };
  EXPECT_EQ(code({}), 2);
  EXPECT_EQ(code({"cap.xyz"}), 2);
  EXPECT_EQ(code({"cap.xyz", "cap.csv"}), 2);
  EXPECT_NE(last_.err.find("--tool-radius"), std::string::npos);
  EXPECT_EQ(code({"cap.xyz", "cap.csv", "--tool-radius", "x"}), 2);
  EXPECT_EQ(code({"cap.xyz", "cap.csv", "--tool-radius", "3", "--scallop", "4"}), 2);
  EXPECT_EQ(code({"cap.xyz", "cap.csv", "--tool-radius", "3", "-o", "a.csv"}), 2);
  EXPECT_EQ(code({"cap.xyz", "none.csv", "--tool-radius", "3"}), 1);
  EXPECT_NE(last_.err.find("none.csv"), std::string::npos);
  EXPECT_EQ(code({"cap.xyz", "cap.xyz", "--tool-radius", "3", "-o", "a.json"}), 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("a.json")));
  EXPECT_EQ(code({"--help"}), 0);
  EXPECT_EQ(code({"cap.xyz", "cap.csv", "--tool-radius", "3", "--max-gauge", "1"}), 2);
  EXPECT_NE(last_.err.find("--max-gauge is not an option; did you mean 'max-gouge'?"), std::string::npos) << last_.err;
  EXPECT_EQ(code({"cap.xyz", "cap.csv", "--tool-radius", "3", "--max-gouge", "-1"}), 2);
  EXPECT_NE(last_.err.find("--max-gouge -1: must be 0 mm or more"), std::string::npos) << last_.err;
  for (const char* output : {"a.png", "a.vtp"}) { // they show one path
    EXPECT_EQ(code({"cap.xyz", "cap.csv", "cap.pcd", "--tool-radius", "3", "-o", output}), 2);
    EXPECT_NE(last_.err.find("give only one path, or write .json or .html"), std::string::npos) << last_.err;
  }
  EXPECT_EQ(code({"cap.xyz", "cap.vtp", "--tool-radius", "3", "-o", "cap.vtp"}), 2);
  EXPECT_NE(last_.err.find("cap.vtp, which is read"), std::string::npos) << last_.err;
  writeText(folder_.path("region.ply"), "-9 -9\n9 -9\n9 9\n-9 9\n");
  EXPECT_EQ(code({"cap.xyz", "cap.csv", "--tool-radius", "3", "--region", "region.ply", "--stock", "region.ply"}), 2);
  EXPECT_NE(last_.err.find("region.ply, which is read"), std::string::npos) << last_.err;
  EXPECT_EQ(code({"", "cap.csv", "--tool-radius", "3"}), 2);
}

TEST_F(Verify, AJobFileSaysWhatTheCommandLineSays)
{
  const auto json = [&](const Arguments& arguments) {
    last_ = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
    EXPECT_EQ(last_.code, 0) << last_.err;
    nlohmann::json report = nlohmann::json::parse(readText(folder_.path("v.json")));
    for (nlohmann::json& path : report["paths"]) {
      path.erase("seconds");
      path["deviation"].erase("seconds");
      path["material"].erase("seconds");
    }
    return report["paths"].dump();
  };
  writeText(folder_.path("job.yaml"), "file: [cap.xyz, cap.csv]\ntool-radius: 3\nscallop: 0.02\nmax-gouge: 0.5\noutput: [v.json]\n");
  const std::string by_options =
      json({"cap.xyz", "cap.csv", "--tool-radius", "3", "--scallop", "0.02", "--max-gouge", "0.5", "-o", "v.json"});
  EXPECT_EQ(json({"--config", "job.yaml"}), by_options);
  EXPECT_NE(json({"--config", "job.yaml", "--scallop", "0.04"}), by_options) << "the command line goes first";
  writeText(folder_.path("job.yaml"), "tool-radios: 3\n");
  last_ = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, {"cap.xyz", "cap.csv", "--config", "job.yaml"}, folder_), folder_);
  EXPECT_EQ(last_.code, 2);
  EXPECT_NE(last_.err.find("did you mean 'tool-radius'?"), std::string::npos) << last_.err;
}

} // namespace

} // namespace verify_test
