#include "display_surface.h"

#include <pcl_spiral/visualization/verification_pictures.h>

#include <stdexcept>

namespace pcl_spiral {
namespace {

void
check(const std::vector<float>& values, std::size_t points, const char* what)
{
  if (!values.empty() && values.size() != points)
    throw std::invalid_argument(std::to_string(values.size()) + " " + what + " for " +
                                std::to_string(points) + " points; one a point is needed");
}

VerificationScene
checked(VerificationScene scene)
{
  if (!scene.part.cloud || !scene.part.path || scene.part.path->empty())
    throw std::invalid_argument("pictures of a verification need the reference and the path");
  check(scene.deviation, scene.part.path->size(), "deviations");
  check(scene.stock, scene.part.cloud->size(), "heights of stock");
  check(scene.ridges, scene.part.cloud->size(), "heights of ridges");
  return scene;
}

} // namespace

VerificationPictures::VerificationPictures(VerificationScene scene)
    : scene_(checked(std::move(scene))),
      surface_(std::make_unique<DisplaySurface>(displaySurface(scene_.part)))
{
}

VerificationPictures::~VerificationPictures() = default;

} // namespace pcl_spiral
