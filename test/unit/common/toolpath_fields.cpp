// SPDX-License-Identifier: BSD-3-Clause
// The generator writes only to the fields that a point type has, of any number type.
#include <pcl_spiral/common/impl/toolpath_fields.h>

// an own type comes before ToolpathPoint is known: the names of the fields are the trait's
struct TurnPoint {
  PCL_ADD_POINT4D;
  float reflectance = 0.5f;
  float turn = -1.0f;
  float arc_length = -1.0f;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(TurnPoint,
                                  (float, x, x)(float, y, y)(float, z, z)(float, reflectance,
                                                                          reflectance)(float, turn, turn)(float, arc_length, arc_length))

#include <pcl_spiral/common/point_types.h>

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>

#include <array>
#include <cstdint>
#include <limits>

using pcl_spiral::ToolpathFields;

namespace {

/** No value fits exactly into a float, and no two are equal. */
struct Written {
  Eigen::Vector3d contact{100.1, -20.7, 3.000000001};
  Eigen::Vector3d normal = Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  Eigen::Vector3f axis = Eigen::Vector3f(-1.0f, 0.5f, 4.0f).normalized();
  double arc_length = 123456.789;
  float turn = 37.375f;
  bool over_gap = true;

  template <typename PointT>
  PointT to(PointT point = PointT()) const
  {
    ToolpathFields<PointT>::set(point, contact, normal, axis, arc_length, turn, over_gap);
    return point;
  }
};

} // namespace

/** Numbers of every kind, with other member names. */
struct OddPoint {
  double east = 0.0, north = 0.0, up = 0.0;
  double nx = 0.0;
  std::int32_t whole_mm = 0;
  std::uint16_t whole_turns = 0;
  bool guessed = false;
  std::array<float, 2> spare{7.0f, 8.0f};
};
POINT_CLOUD_REGISTER_POINT_STRUCT(OddPoint,
                                  (double, east, x)(double, north, y)(double, up, z)(double, nx, normal_x)(
                                      std::int32_t, whole_mm, arc_length)(std::uint16_t, whole_turns, turn)(bool, guessed, over_gap))

/** A point type without names in PCL. */
struct Station {
  Eigen::Vector3f lifted = Eigen::Vector3f::Zero();
  double metres = 0.0;
};
template <>
struct pcl_spiral::ToolpathFields<Station> {
  static void set(Station& station, const Eigen::Vector3d& contact, const Eigen::Vector3d& normal, const Eigen::Vector3f&,
                  double arc_length, float, bool)
  {
    station.lifted = (contact + 10.0 * normal).cast<float>();
    station.metres = 0.001 * arc_length;
  }
};

TEST(ToolpathFields, ToolpathPointTakesEverything)
{
  const Written written;
  const auto point = written.to<pcl_spiral::ToolpathPoint>();
  EXPECT_EQ(point.getVector3fMap(), written.contact.cast<float>());
  EXPECT_EQ(point.getNormalVector3fMap(), written.normal.cast<float>());
  EXPECT_EQ(point.getAxisVector3fMap(), written.axis);
  EXPECT_EQ(point.arc_length, written.arc_length);
  EXPECT_EQ(point.turn, written.turn);
  EXPECT_EQ(point.over_gap, 1);
  EXPECT_EQ(point.data[3], 1.0f);
  EXPECT_EQ(point.data_n[3], 0.0f);
  EXPECT_EQ(point.data_axis[3], 0.0f);
  Written beside;
  beside.over_gap = false;
  EXPECT_EQ(beside.to(point).over_gap, 0) << "written over, not added up";
}

TEST(ToolpathFields, PointsOfPclTakeWhatTheyHave)
{
  const Written written;
  const auto place = written.to<pcl::PointXYZ>();
  EXPECT_EQ(place.getVector3fMap(), written.contact.cast<float>());
  EXPECT_EQ(place.data[3], 1.0f);

  pcl::PointNormal before;
  before.curvature = 0.25f;
  const auto oriented = written.to(before);
  EXPECT_EQ(oriented.getVector3fMap(), written.contact.cast<float>());
  EXPECT_EQ(oriented.getNormalVector3fMap(), written.normal.cast<float>());
  EXPECT_EQ(oriented.curvature, 0.25f);

  const auto grey = written.to<pcl::PointXYZI>();
  EXPECT_EQ(grey.getVector3fMap(), written.contact.cast<float>());
  EXPECT_EQ(grey.intensity, pcl::PointXYZI().intensity);
}

TEST(ToolpathFields, OwnPointTakesWhatItHasRegistered)
{
  const Written written;
  const auto point = written.to<TurnPoint>();
  EXPECT_EQ(point.getVector3fMap(), written.contact.cast<float>());
  EXPECT_EQ(point.turn, written.turn);
  EXPECT_EQ(point.arc_length, static_cast<float>(written.arc_length));
  EXPECT_EQ(point.reflectance, 0.5f);
}

TEST(ToolpathFields, AnyNumberTypeUnderAnyMemberName)
{
  const Written written;
  const auto point = written.to<OddPoint>();
  EXPECT_EQ(Eigen::Vector3d(point.east, point.north, point.up), written.contact) << "in double precision";
  EXPECT_EQ(point.nx, written.normal.x()) << "though the type has no normal_y and normal_z";
  EXPECT_EQ(point.whole_mm, 123456);
  EXPECT_EQ(point.whole_turns, 37);
  EXPECT_TRUE(point.guessed);
  EXPECT_EQ(point.spare, (std::array<float, 2>{7.0f, 8.0f}));
}

TEST(ToolpathFields, WhatAWholeNumberCannotHoldIsTheNearestItCan)
{
  Written written;
  written.turn = -0.7f;
  written.arc_length = 1e12;
  auto point = written.to<OddPoint>();
  EXPECT_EQ(point.whole_turns, 0);
  EXPECT_EQ(point.whole_mm, std::numeric_limits<std::int32_t>::max());
  written.turn = 70000.0f;
  written.arc_length = -1e12;
  point = written.to<OddPoint>();
  EXPECT_EQ(point.whole_turns, 65535);
  EXPECT_EQ(point.whole_mm, std::numeric_limits<std::int32_t>::lowest());
  written.arc_length = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(written.to<OddPoint>().whole_mm, 0);
  EXPECT_EQ(pcl_spiral::numberAs<std::int64_t>(9.3e18), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(pcl_spiral::numberAs<std::int64_t>(-2.9), -2);
}

TEST(ToolpathFields, ASpecialisationStandsForTheDefault)
{
  const Written written;
  const auto station = written.to<Station>();
  EXPECT_EQ(station.lifted, (written.contact + 10.0 * written.normal).cast<float>());
  EXPECT_EQ(station.metres, 123.456789);
}
