// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/visualization/spiral_viewer.h>

#include "viewer_session.h"

namespace pcl_spiral {

SpiralViewer::SpiralViewer(VerificationScene scene) : session_(std::make_unique<ViewerSession>(std::move(scene))) {}

SpiralViewer::~SpiralViewer() = default;

void
SpiralViewer::setRemedy(const std::string& remedy)
{
  session_->pages.setRemedy(remedy);
}

void
SpiralViewer::setPictureStem(const std::string& stem)
{
  session_->picture_stem = stem;
}

void
SpiralViewer::setFileCoordinates(std::function<Eigen::Vector3d(const Eigen::Vector3d&)> in_file)
{
  session_->in_file = std::move(in_file);
}

void
SpiralViewer::setChoiceCallback(std::function<std::string(const PartSelection&)> chosen)
{
  session_->chosen = std::move(chosen);
}

void
SpiralViewer::setPlayback(PlaybackScene playback)
{
  session_->setPlayback(std::move(playback));
}

void
SpiralViewer::setCloseRequest(std::function<bool()> wanted)
{
  session_->close_wanted = std::move(wanted);
}

void
SpiralViewer::run()
{
  session_->run();
}

ViewerPage
SpiralViewer::getPage() const
{
  return session_->choice.page;
}

std::optional<std::size_t>
SpiralViewer::getChosenPoint() const
{
  return session_->choice.point;
}

std::optional<Eigen::Vector3d>
SpiralViewer::getChosenPlace() const
{
  return session_->place;
}

const std::string&
SpiralViewer::getMessage() const
{
  return session_->message;
}

vtkRenderWindowInteractor*
SpiralViewer::getInteractor() const
{
  return session_->interactor;
}

} // namespace pcl_spiral
