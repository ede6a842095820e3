// SPDX-License-Identifier: BSD-3-Clause
#include "playback_page.h"

#include "cutter_actor.h"
#include "visualization/path_layer.h"

#include <pcl_spiral/core/impl/angles.h>

#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRegularPolygonSource.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int bar_left = 30, bar_bottom = 108, bar_reach = 14, words_size = 17, first_bottom = 72, second_bottom = 46; ///< pixels
constexpr double knob_radius = 8.0;                                                                                    ///< pixels
constexpr Color bar_color{0.55, 0.58, 0.63}, knob_color{0.10, 0.30, 0.90};

const char*
nameOf(const ProgramBlock& block)
{
  if (block.rapid)
    return "rapid";
  switch (block.section) {
  case BlockSection::Cut:
    return "cuts";
  case BlockSection::Link:
    return "link";
  case BlockSection::LeadIn:
  case BlockSection::LeadOut:
    return "lead";
  default:
    return "off the part";
  }
}

std::string
clockText(double seconds)
{
  const auto whole = static_cast<long>(seconds);
  return formatted("%ld:%02ld:%04.1f", whole / 3600, whole / 60 % 60, seconds - static_cast<double>(whole / 60 * 60));
}

std::string
stockWords(const std::string& fault)
{
  return fault.empty() ? "; the stock is being computed" : "; the stock could not be computed: " + fault;
}

void
setWords(vtkTextActor* actor, int bottom)
{
  actor->GetTextProperty()->SetFontSize(words_size);
  actor->GetTextProperty()->SetFontFamilyToCourier();
  actor->GetTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  actor->SetPosition(bar_left, bottom);
}

} // namespace

PlaybackPage::PlaybackPage(Player& player, const VerificationScene& scene, ViewerWindow& window)
: player_(player), scene_(scene), window_(window), scale_(scene)
{
  setWords(first_, first_bottom);
  setWords(second_, second_bottom);
}

void
PlaybackPage::start()
{
  patches_ = std::make_unique<StockPatches>(player_.scene().left, scale_.style());
  for (std::size_t i = 0; i < player_.scene().left.places.size(); ++i)
    patches_->set(i, static_cast<float>(scene_.removal_figures.reach));
  tool_ = toolActor(player_.scene().cutter, player_.scene().holder);
  vtkNew<vtkRegularPolygonSource> disc;
  disc->SetNumberOfSides(24);
  disc->SetRadius(knob_radius);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(disc->GetOutputPort());
  knob_ = vtkSmartPointer<vtkActor2D>::New();
  knob_->SetMapper(mapper);
  knob_->GetProperty()->SetColor(knob_color[0], knob_color[1], knob_color[2]);
}

int
PlaybackPage::barLength() const
{
  return std::max(50, window_.page().wordsLeft() - 2 * bar_left - 24);
}

bool
PlaybackPage::isOnBar(int x, int y) const
{
  return std::abs(y - bar_bottom) <= bar_reach && x >= bar_left - bar_reach && x <= bar_left + barLength() + bar_reach;
}

double
PlaybackPage::shareAt(int x) const
{
  return std::clamp((x - bar_left) / static_cast<double>(barLength()), 0.0, 1.0);
}

int
PlaybackPage::fill()
{
  window_.clear();
  if (!patches_)
    start();
  for (const auto& actor : patches_->actors())
    window_.add(actor);
  window_.add(tool_);
  vtkRenderer* const words = window_.words();
  addStrokes(words, {{Eigen::Vector2d(bar_left, bar_bottom), Eigen::Vector2d(bar_left + barLength(), bar_bottom)}}, bar_color, 4.0f);
  words->AddActor2D(knob_);
  words->AddActor2D(first_);
  words->AddActor2D(second_);
  const std::string what = player_.scene().program ? "program" : "path";
  addTitle(words, window_.page(), scene_.part.title + ": " + what + " in time",
           std::to_string(player_.time().track.blocks()) + " blocks, " + clockText(player_.time().track.seconds()) + " on " +
               controlModel(player_.scene().control).name + "; shares at the right: when all is done");
  addColorBar(words, window_.page(), "stock, mm", scale_.colors());
  update();
  return addLegend(words, window_.page(), scale_.legend(scene_.stock));
}

void
PlaybackPage::update()
{
  const MotionFrame frame = player_.frame();
  const Eigen::Vector3d x = frame.axis.unitOrthogonal(), y = frame.axis.cross(x);
  vtkNew<vtkMatrix4x4> matrix;
  for (int r = 0; r < 3; ++r) {
    matrix->SetElement(r, 0, x[r]);
    matrix->SetElement(r, 1, y[r]);
    matrix->SetElement(r, 2, frame.axis[r]);
    matrix->SetElement(r, 3, frame.tip[r]);
  }
  tool_->SetUserMatrix(matrix);
  player_.fallTo([this](std::size_t place, float height) { patches_->set(place, height); });
  patches_->finish();
  fallen_ = player_.hasStock();
  knob_->SetPosition(bar_left + player_.share() * barLength(), bar_bottom);
  writeWords(frame);
}

void
PlaybackPage::writeWords(const MotionFrame& frame)
{
  const PlaybackTime& time = player_.time();
  const ProgramBlock& block = time.track.program().blocks[frame.block];
  const Machine& machine = time.track.program().machine;
  const auto& path = *scene_.part.path;
  place_ = clockText(frame.seconds) +
           formatted("  %5.1f %% by %s  x%g  ", 100.0 * player_.share(), player_.byLength() ? "length" : "time", player_.speed()) +
           "block " + std::to_string(frame.block) + (time.lines.empty() ? "" : ", line " + std::to_string(time.lines[frame.block])) +
           formatted(", turn %.2f, %s", path[std::min(player_.moves(), path.size() - 1)].turn, nameOf(block)) +
           (fallen_ ? "" : stockWords(player_.stockFault()));
  motion_ = formatted("feed %6.0f", frame.feed) + (frame.asked > 0.0 ? formatted(" of %6.0f mm/min", frame.asked) : " mm/min, rapid  ");
  if (!machine.three_axes)
    motion_ += formatted("   %c %9.3f  %c %9.3f deg", machine.rotary[0].letter, frame.angles.first * in_degrees, machine.rotary[1].letter,
                         frame.angles.second * in_degrees);
  motion_ += formatted("   tip %.3f %.3f %.3f", frame.tip.x(), frame.tip.y(), frame.tip.z());
  first_->SetInput(place_.c_str());
  second_->SetInput(motion_.c_str());
}

} // namespace pcl_spiral
