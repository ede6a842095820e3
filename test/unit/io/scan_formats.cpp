// SPDX-License-Identifier: BSD-3-Clause
// Scans of laser scanners: LAS of all versions and point formats, PTS with one block and several, units of feet, and refusals that name
// the command which converts.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/file_error.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace scan_formats_test {

using namespace pcl_spiral;

namespace {

constexpr double scale = 0.0001;
const Eigen::Vector3d offset(393775.0, 3689071.0, 3000.0);
const std::vector<std::array<std::int32_t, 3>> records{{4000, 2000, 1070000}, {-12345, 0, 7}, {2147483647, -2147483647, 1}};
constexpr std::array<std::size_t, 11> record_sizes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67}; ///< of the formats 0 to 10

template <typename T>
void
put(std::string& bytes, std::size_t at, T value)
{
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/** A LAS file by the tables of the specification; records have \p extra bytes behind them. */
std::string
lasFile(std::uint8_t minor, std::uint8_t format, std::size_t extra = 0)
{
  const std::size_t header = minor == 4 ? 375 : minor == 3 ? 235 : 227, begin = header + 54; // a record of variable length between them
  const std::size_t size = record_sizes[format & 0x3FU] + extra;
  std::string bytes(begin + size * records.size(), '\x5A');
  std::fill_n(bytes.begin(), header, '\0');
  bytes.replace(0, 4, "LASF");
  put<std::uint8_t>(bytes, 24, 1);
  put(bytes, 25, minor);
  put(bytes, 94, static_cast<std::uint16_t>(header));
  put(bytes, 96, static_cast<std::uint32_t>(begin));
  put(bytes, 104, format);
  put(bytes, 105, static_cast<std::uint16_t>(size));
  if (minor == 4) // the older count is 0 for the formats from 6 on
    put(bytes, 247, static_cast<std::uint64_t>(records.size()));
  else
    put(bytes, 107, static_cast<std::uint32_t>(records.size()));
  for (int c = 0; c < 3; ++c) {
    put(bytes, 131 + 8 * c, scale);
    put(bytes, 155 + 8 * c, offset[c]);
  }
  for (std::size_t i = 0; i < records.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      put(bytes, begin + i * size + 4 * c, records[i][c]);
  return bytes;
}

/** A record of variable length for the coordinate system, of type \p id. */
std::string
projectionRecord(std::uint16_t id, const std::string& body, bool extended = false)
{
  std::string record(extended ? 60 : 54, '\0');
  record.replace(2, 15, "LASF_Projection");
  put(record, 18, id);
  if (extended)
    put(record, 20, static_cast<std::uint64_t>(body.size()));
  else
    put(record, 20, static_cast<std::uint16_t>(body.size()));
  return record + body;
}

/** Keys of GeoTIFF with their values. */
std::string
geoKeys(const std::vector<std::array<std::uint16_t, 2>>& keys)
{
  std::string body(8 + 8 * keys.size(), '\0');
  put<std::uint16_t>(body, 0, 1);
  put<std::uint16_t>(body, 2, 1);
  put(body, 6, static_cast<std::uint16_t>(keys.size()));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    put(body, 8 + 8 * i, keys[i][0]);
    put<std::uint16_t>(body, 12 + 8 * i, 1);
    put(body, 14 + 8 * i, keys[i][1]);
  }
  return projectionRecord(34735, body);
}

/** \p las with \p record between its header and its points, as its only one; for version 1.4 behind the points, if \p behind. */
std::string
withRecord(std::string las, const std::string& record, bool behind = false)
{
  std::uint16_t header = 0;
  std::uint32_t begin = 0;
  std::memcpy(&header, &las[94], 2);
  std::memcpy(&begin, &las[96], 4);
  if (behind) {
    put(las, 235, static_cast<std::uint64_t>(las.size()));
    put<std::uint32_t>(las, 243, 1);
    return las + record;
  }
  las.replace(header, begin - header, record);
  put(las, 96, static_cast<std::uint32_t>(header + record.size()));
  put<std::uint32_t>(las, 100, 1);
  return las;
}

/** \p las with records near longitude 11.5 and latitude 48.1, with steps of \p degrees and \p metres. */
std::string
inDegrees(std::string las, double degrees, double metres)
{
  std::uint32_t begin = 0;
  std::uint16_t size = 0;
  std::memcpy(&begin, &las[96], 4);
  std::memcpy(&size, &las[105], 2);
  const std::array<double, 3> steps{degrees, degrees, metres}, offsets{11.5, 48.1, 500.0};
  for (int c = 0; c < 3; ++c) {
    put(las, 131 + 8 * c, steps[static_cast<std::size_t>(c)]);
    put(las, 155 + 8 * c, offsets[static_cast<std::size_t>(c)]);
    for (std::size_t i = 0; i < records.size(); ++i)
      put(las, begin + i * size + 4 * static_cast<std::size_t>(c), static_cast<std::int32_t>((i + 1) * 100 * (c + 1) % 700));
  }
  return las;
}

class ScanFormats : public ::testing::Test {
protected:
  Scan read(const std::string& name, const std::string& content, const ReadOptions& options = {})
  {
    writeText(folder_.path(name), content);
    return readCloud(folder_.path(name), options);
  }

  void expectProblem(const std::string& name, const std::string& content, const std::string& part)
  {
    try {
      read(name, content);
      ADD_FAILURE() << name << " was read";
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << "'" << part << "' in: " << error.what();
    }
  }

  ScratchFolder folder_;
};

} // namespace

TEST_F(ScanFormats, LasOfAllVersionsAndFormatsInDoublePrecision)
{
  ReadOptions options;
  options.unit = LengthUnit::Metre;
  options.origin = offset;
  for (const auto& [minor, format] :
       {std::pair(0, 0), {0, 1}, {1, 1}, {2, 2}, {2, 3}, {3, 4}, {3, 5}, {4, 6}, {4, 7}, {4, 8}, {4, 9}, {4, 10}})
    for (const std::size_t extra : {0, 5}) {
      SCOPED_TRACE("LAS 1." + std::to_string(minor) + ", format " + std::to_string(format));
      const Scan scan = read("scan.LAS", lasFile(static_cast<std::uint8_t>(minor), static_cast<std::uint8_t>(format), extra), options);
      ASSERT_EQ(scan.cloud->size(), records.size());
      for (std::size_t i = 0; i < records.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
          const double exact = 1000.0 * scale * records[i][c]; // mm from the offset
          EXPECT_NEAR((*scan.cloud)[i].data[c], exact, 1e-6 + 6e-8 * std::abs(exact)) << i << ' ' << c;
        }
    }
}

TEST_F(ScanFormats, BrokenLasFiles)
{
  expectProblem("a.las", "LASX" + std::string(400, '\0'), "must begin with LASF");
  expectProblem("b.las", lasFile(2, 0).substr(0, 200), "cut off in its header");
  const std::string whole = lasFile(2, 0);
  expectProblem("c.las", whole.substr(0, whole.size() - 1), "but its header gives 3 points of 20 bytes from byte 281");
  std::string later = lasFile(4, 6);
  put<std::uint8_t>(later, 25, 5);
  expectProblem("d.las", later, "is LAS 1.5 with points of format 6; versions 1.0 to 1.4");
  std::string narrow = lasFile(2, 3);
  put<std::uint16_t>(narrow, 105, 20);
  expectProblem("e.las", narrow, "20 bytes for a point of format 3, which has at least 34");
  std::string none = lasFile(2, 0);
  put<std::uint32_t>(none, 107, 0);
  expectProblem("f.las", none, "holds no points");
  std::string many = lasFile(4, 6);
  put<std::uint64_t>(many, 247, 0xFFFFFFFFFFFFFFFFULL);
  expectProblem("g.las", many, "it is cut off");
}

TEST_F(ScanFormats, OtherFormatsAreRefusedWithTheCommandThatConverts)
{
  const std::string to_ply = "scan.ply --writers.ply.storage_mode=\"little endian\"";
  expectProblem("scan.laz", "LASF", "pdal translate " + folder_.path("scan.laz") + " " + folder_.path(to_ply));
  expectProblem("scan.E57", "ASTM-E57", "pdal translate " + folder_.path("scan.E57") + " " + folder_.path(to_ply));
  expectProblem("scan.las", lasFile(2, 0x80 | 3), "its points are compressed; convert it with PDAL");
}

TEST_F(ScanFormats, PtsWithOneBlockAndSeveral)
{
  ReadOptions options;
  options.unit = LengthUnit::Metre;
  const Scan plain = read("a.pts", "2\r\n1 2 3\r\n4 5 6\r\n", options);
  ASSERT_EQ(plain.cloud->size(), 2U);
  EXPECT_FLOAT_EQ((*plain.cloud)[1].z, 6000.0f);
  const Scan two = read("b.PTS", "1\n1 2 3 -1024 255 0 128\n\n2\n4 5 6 0.5\n7 8 9 17\n");
  ASSERT_EQ(two.cloud->size(), 3U);
  EXPECT_FLOAT_EQ((*two.cloud)[2].x, 7.0f);
  expectProblem("c.pts", "3\n1 2 3\n4 5 6\n", "ends 1 points before");
  expectProblem("d.pts", "1 2 3\n4 5 6\n", "line 1: '1 2 3' must be the number of points that follow");
  expectProblem("e.pts", "1\n1 2 3\n4 5 6\n", "line 3: '4 5 6' must be the number");
  expectProblem("f.pts", "2\n1 2 3\n4 5\n", "line 3: 2 column(s)");
  expectProblem("g.pts", "1\n1 b 3\n", "line 2: 'b' is not a number");
  expectProblem("h.pts", "0\n", "holds no points");
}

TEST_F(ScanFormats, FeetAreExact)
{
  EXPECT_EQ(millimetres(LengthUnit::Foot), 304.8);
  EXPECT_EQ(millimetres(LengthUnit::SurveyFoot), 1200000.0 / 3937.0);
  EXPECT_NEAR(millimetres(LengthUnit::SurveyFoot) / millimetres(LengthUnit::Foot) - 1.0, 2.000004e-6, 1e-11); // NIST SP 811, B.6
  ReadOptions options;
  options.unit = LengthUnit::Foot;
  EXPECT_FLOAT_EQ((*read("a.xyz", "100 0 0\n0 0 1\n", options).cloud)[0].x, 30480.0f);
  options.unit = LengthUnit::SurveyFoot;
  EXPECT_FLOAT_EQ((*read("a.xyz", "100 0 0\n0 0 1\n", options).cloud)[0].x, 30480.06096f);
}

TEST_F(ScanFormats, WithheldPointsOfLasAreLeftOutAndCounted)
{
  ReadOptions options;
  options.unit = LengthUnit::Metre;
  options.origin = offset;
  for (std::uint8_t format = 0; format <= 10; ++format) {
    SCOPED_TRACE("format " + std::to_string(format));
    std::string las = lasFile(format < 6 ? 2 : 4, format);
    const std::size_t begin = las.size() - records.size() * record_sizes[format];
    const auto flags = [&](std::size_t i) { return begin + i * record_sizes[format] + 15; };
    for (std::size_t i = 0; i < records.size(); ++i)
      las[flags(i)] = static_cast<char>(format < 6 ? 0x60 : 0x0B); // synthetic, key point, overlap: these are points
    EXPECT_EQ(read("a.las", las, options).cloud->size(), records.size());
    las[flags(1)] = static_cast<char>(format < 6 ? 0x82 : 0x04);
    const Scan scan = read("a.las", las, options);
    ASSERT_EQ(scan.cloud->size(), 2U);
    EXPECT_NEAR((*scan.cloud)[1].z, 1000.0 * scale * records[2][2], 1e-6);
    ASSERT_FALSE(scan.warnings.empty());
    EXPECT_NE(scan.warnings[0].text().find("1 of 3 points is flagged withheld and was left out"), std::string::npos) << scan.warnings[0];
    las[flags(0)] = las[flags(2)] = las[flags(1)];
    expectProblem("a.las", las, "all of its 3 points are flagged withheld");
  }
}

TEST_F(ScanFormats, DegreesOfLasAreRefusedWithTheCommandThatReprojects)
{
  const std::string wgs = "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257]],UNIT[\"degree\",0.0174]]";
  const std::string degrees = "are degrees, longitude and latitude, but a tool needs lengths: reproject them to metres";
  const std::string las = lasFile(2, 1), late = lasFile(4, 6);
  for (const std::string& named :
       {withRecord(las, geoKeys({{1024, 2}, {2048, 4326}})), withRecord(las, geoKeys({{2048, 4258}})),
        withRecord(late, projectionRecord(2112, wgs)), withRecord(late, projectionRecord(2112, wgs, true), true),
        withRecord(late, projectionRecord(2112, "GEOGCRS [\"WGS 84\"]")), withRecord(late, projectionRecord(2112, "COMPD_CS[\"a\"," + wgs)),
        withRecord(late, projectionRecord(2112, "GEODCRS[\"a\",CS[ellipsoidal,2]]"))})
    expectProblem("a.las", inDegrees(named, 1e-7, 0.001), degrees);
  expectProblem("my scan.las", withRecord(inDegrees(las, 1e-7, 0.001), geoKeys({{1024, 2}, {2048, 4326}})),
                "pdal translate '" + folder_.path("my scan.las") + "' '" + folder_.path("my scan_metres.las") +
                    "' reprojection --filters.reprojection.out_srs='+proj=tmerc +lat_0=48.1");
  expectProblem("a.las", inDegrees(las, 1e-7, 0.001), "names no coordinate system, but its coordinates, by their ranges, " + degrees);
  expectProblem("a.las", inDegrees(las, 1e-7, 0.01), "in_srs=EPSG:4326");
  expectProblem("a.las", inDegrees(las, 1e-9, 1e-4), degrees);
}

TEST_F(ScanFormats, LengthsAreNoDegrees)
{
  const std::string utm = "PROJCS[\"UTM 32N\",GEOGCS[\"WGS 84\"],UNIT[\"metre\",1]]";
  const std::string las = lasFile(2, 1), late = lasFile(4, 6);
  const auto isRead = [this](const std::string& content) { EXPECT_EQ(read("a.las", content).cloud->size(), records.size()); };
  isRead(withRecord(las, geoKeys({{1024, 1}, {2048, 4326}, {3072, 32632}})));
  isRead(withRecord(las, geoKeys({{2048, 4326}, {3072, 32632}})));
  isRead(withRecord(late, projectionRecord(2112, utm)));
  isRead(withRecord(late, projectionRecord(2112, "PROJCRS[\"UTM\",BASEGEOGCRS[\"WGS 84\"],CS[Cartesian,2]]")));
  isRead(withRecord(late, projectionRecord(2112, "GEODCRS[\"a\",CS[Cartesian,3]]")));
  isRead(inDegrees(withRecord(las, geoKeys({{1024, 1}, {3072, 32632}})), 1e-7, 0.001)); // it says that they are lengths
  isRead(inDegrees(las, 1e-4, 1e-4));                                                   // a scan of 0.1 m at 48 m
  isRead(withRecord(las, geoKeys({{1024, 2}}).substr(0, 60)));                          // cut off
}

TEST_F(ScanFormats, TextThatLooksLikeDegreesIsWarnedOf)
{
  const Scan far = read("a.xyz", "11.5000001 48.1000002 500\n11.5000003 48.1000001 500.01\n11.5000002 48.1000004 500.02\n");
  ASSERT_FALSE(far.warnings.empty());
  EXPECT_NE(far.warnings[0].text().find("look as if they are degrees"), std::string::npos) << far.warnings[0];
  for (const std::string& scan : {"11.5 48.1 0\n11.5 48.1 100\n", "0 0 0\n0.001 0.001 50\n", "50 50 0\n51 52 30\n"})
    for (const pcl_spiral::Diagnostic& warning : read("b.xyz", scan).warnings)
      EXPECT_EQ(warning.text().find("degrees"), std::string::npos) << warning;
}

} // namespace scan_formats_test
