// SPDX-License-Identifier: BSD-3-Clause
#include "display_surface.h"
#include "scene_check.h"

namespace pcl_spiral {

VerificationPictures::VerificationPictures(VerificationScene scene)
: scene_(checkedScene(std::move(scene))), surface_(std::make_unique<DisplaySurface>(displaySurface(scene_.part)))
{}

VerificationPictures::~VerificationPictures() = default;

} // namespace pcl_spiral
