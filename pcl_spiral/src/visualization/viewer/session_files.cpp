// SPDX-License-Identifier: BSD-3-Clause
// What the viewer writes: views, and the choice of the part.
#include "viewer_session.h"

#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/io/file_error.h>

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <filesystem>

namespace pcl_spiral {
namespace {

constexpr double least_side = 2.0; ///< of a lasso, pixels

} // namespace

/** STEM_KIND_1.ext, the first name that does not exist. */
std::string
ViewerSession::newFile(const std::string& kind) const
{
  const std::string stem = picture_stem + kind + "_", extension = kind.empty() ? ".png" : ".txt";
  std::string file;
  for (int i = 1; file.empty() || std::filesystem::exists(file); ++i)
    file.assign(stem).append(std::to_string(i)).append(extension);
  return file;
}

void
ViewerSession::savePicture()
{
  const std::string file = newFile("");
  show();
  try {
    writePNG(window.window(), file);
    message = "saved " + file;
  }
  catch (const FileError& error) {
    message = error.what();
  }
}

void
ViewerSession::choosePlace(int x, int y)
{
  place = choice.page == ViewerPage::Histogram ? std::nullopt : pickScanPoint(window, *scene.part.cloud, Eigen::Vector2d(x, y));
  if (!place) {
    message = "no point of the scan is within 12 pixels of the mouse";
    return;
  }
  message = chosen({placeInFile(*place, in_file), "", 0});
}

void
ViewerSession::beginLasso()
{
  if (choice.page == ViewerPage::Histogram) {
    message = "there is no scan on this page: go to page 1";
    return;
  }
  lasso_.clear();
  style->lasso = true;
  message = "drag round the points with the left button; the first and the last place are connected";
}

void
ViewerSession::draw(int x, int y)
{
  const Eigen::Vector2d pixel(x, y);
  if (!lasso_.empty() && (pixel - lasso_.back()).norm() < least_side)
    return;
  lasso_.push_back(pixel);
  window.setLasso(lasso_);
  window.render();
}

void
ViewerSession::endLasso()
{
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector2d& pixel : lasso_)
    corners.push_back(window.placeAt(pixel));
  const Prism prism(corners, window.projection().towards());
  if (!prism.fault().empty()) {
    beginLasso();
    message = Diagnostic("this lasso cannot be used: ", prism.fault(), "; draw it again").text();
    return show();
  }
  const std::string file = newFile("_lasso");
  const auto inside = std::count_if(scene.part.cloud->begin(), scene.part.cloud->end(), [&prism](const pcl::PointXYZ& p) {
    return pcl::isFinite(p) && prism.contains(p.getVector3fMap().cast<double>());
  });
  try {
    writePolygon(file, corners, in_file);
    message = chosen({"", file, static_cast<std::size_t>(inside)});
  }
  catch (const FileError& error) {
    message = error.what();
  }
  show();
}

} // namespace pcl_spiral
