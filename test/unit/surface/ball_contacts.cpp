// SPDX-License-Identifier: BSD-3-Clause
// Contacts of balls above and in a sphere that is known exactly.
#include <pcl_spiral/surface/scanned_surface.h>
#include <pcl_spiral/verify/impl/cutter_contacts.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ball_contacts_test {

using namespace pcl_spiral;

namespace {

constexpr double sphere = 100.0, rim = 40.0, ball = 6.0;

pcl::PointCloud<pcl::PointXYZ>::Ptr
cap(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < 8000; ++i) {
    const double r = rim * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    cloud->emplace_back(r * std::cos(angle), r * std::sin(angle), std::sqrt(sphere * sphere - r * r) - sphere);
  }
  return cloud;
}

} // namespace

TEST(BallContacts, HeightAndNormalAreThoseOfTheSphere)
{
  std::mt19937 random(7);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cap(random));
  Surface::ConstPtr surface;
  scanned.compute(surface);
  ASSERT_TRUE(surface) << scanned.getStatus().message();
  const ReferenceSurface reference(surface);
  std::uniform_real_distribution<double> unit(-1.0, 1.0), height(-8.0, 12.0);
  std::vector<Eigen::Vector3d> centres;
  const Eigen::Vector3d middle(0.0, 0.0, -sphere);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d direction = Eigen::Vector3d(0.35 * unit(random), 0.35 * unit(random) * 0.5, 1.0).normalized();
    centres.push_back(middle + (sphere + ball + height(random)) * direction);
  }
  const std::vector<NearestContact> contacts = ballContacts(reference, centres, ball);
  ASSERT_EQ(contacts.size(), centres.size());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    ASSERT_TRUE(contacts[i].valid) << i;
    const Eigen::Vector3d off = centres[i] - middle;
    ASSERT_NEAR(contacts[i].height, off.norm() - sphere - ball, 1e-4) << i;
    ASSERT_LT((contacts[i].normal - off.normalized()).norm() * std::abs(off.norm() - sphere), 5e-4) << i; // of the place on the surface
    ASSERT_LT((contacts[i].position - (centres[i] - ball * contacts[i].normal)).norm(), 1e-9);
  }
}

} // namespace ball_contacts_test
