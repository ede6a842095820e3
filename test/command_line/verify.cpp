// pcl_spiral_verify from outside: figures, faults put in on purpose, limits, exit codes.
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

namespace {

using Arguments = std::vector<std::string>;

/** A cap of a sphere of radius 100 mm, 40 mm across its rim's radius. */
std::string
cap(int count)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::ostringstream text;
  text << std::setprecision(9);
  for (int i = 0; i < count; ++i) {
    const double r = 40.0 * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    text << r * std::cos(angle) << ' ' << r * std::sin(angle) << ' ' << std::sqrt(1e4 - r * r) - 100.0 << '\n';
  }
  return text.str();
}

class Verify : public ::testing::Test {
protected:
  static constexpr double radius = 3.0, scallop = 0.02, chord_error = 0.005;

  void
  SetUp() override
  {
    writeText(folder_.path("cap.xyz"), cap(8000));
    const RunResult made = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                                              {"cap.xyz", "--tool-radius", "3", "--scallop", "0.02", "-o", "cap.csv", "-o",
                                               "cap.pcd", "-o", "cap.ply", "-o", "cap.vtp"},
                                              folder_),
                                 folder_);
    ASSERT_EQ(made.code, 0) << made.err;
  }

  RunResult
  verify(Arguments arguments)
  {
    arguments.insert(arguments.begin(), "cap.xyz");
    arguments.insert(arguments.end(), {"--tool-radius", "3", "--scallop", "0.02"});
    return endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, arguments, folder_), folder_);
  }

  nlohmann::json
  figures(const std::string& path, Arguments arguments = {})
  {
    arguments.insert(arguments.begin(), {path, "-o", "figures.json"});
    last_ = verify(arguments);
    const std::string text = readText(folder_.path("figures.json"));
    return text.empty() ? nlohmann::json() : nlohmann::json::parse(text)["paths"][0];
  }

  /** cap.csv with its rows changed by \p change(fields of a row, row number); rows it empties go. */
  template <typename Change>
  void
  spoil(const Change& change)
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

  ScratchFolder folder_;
  RunResult last_;
};

TEST_F(Verify, AGoodPathKeepsItsLimits)
{
  const auto path = figures("cap.csv", {"--max-gouge", "0.008", "--max-scallop", "0.026", "--max-deviation", "0.003",
                                        "--max-uncut", "0"});
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
}

TEST_F(Verify, FindsAMissingTurn)
{
  double gone = 0.0;
  spoil([&](std::vector<double>& f, std::size_t) {
    if (f[0] >= 20.0 && f[0] < 21.0) {
      gone = f[1];
      f.clear();
    }
  });
  ASSERT_GT(gone, 0.0);
  const auto path = figures("spoilt.csv", {"--max-scallop", "0.03"});
  EXPECT_EQ(last_.code, 1);
  // Twice the pitch leaves four times the height.
  EXPECT_NEAR(path["material"]["scallop"]["max"]["value"], 4.0 * scallop, 0.15 * 4.0 * scallop);
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
  EXPECT_EQ(code({"cap.xyz", "cap.csv", "cap.pcd", "--tool-radius", "3", "-o", "a.png"}), 2); // one path a picture
}

} // namespace
