// SPDX-License-Identifier: BSD-3-Clause
#include "playback_page.h"

#include "cutter_actor.h"
#include "visualization/path_layer.h"

#include <pcl_spiral/core/impl/angles.h>

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
  const DisplaySurface& part = window_.surface();
  machine_ = std::make_unique<MachineActors>(machineSolids(player_.time().track.program().machine, {part.low, part.high},
                                                           toolHeight(player_.scene().cutter, player_.scene().holder)));
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
  for (const auto& actor : machine_->actors())
    if (shows_machine_)
      window_.add(actor);
  vtkRenderer* const words = window_.words();
  addStrokes(words, {{Eigen::Vector2d(bar_left, bar_bottom), Eigen::Vector2d(bar_left + barLength(), bar_bottom)}}, bar_color, 4.0f);
  words->AddActor2D(knob_);
  words->AddActor2D(first_);
  words->AddActor2D(second_);
  const std::string what = player_.playsProgram() ? "program" : "path";
  addTitle(words, window_.page(), scene_.part.title + ": " + what + " in time",
           std::to_string(player_.time().track.blocks()) + " blocks, " + clockText(player_.time().track.seconds()) + " on " +
               controlModel(player_.scene().control).name +
               formatted(", stock of %zu places; shares at the right: when all is done", player_.scene().left.places.size()));
  addColorBar(words, window_.page(), "stock, mm", scale_.colors());
  update();
  return addLegend(words, window_.page(), scale_.legend(scene_.stock));
}

void
PlaybackPage::update()
{
  const MotionFrame frame = player_.frame();
  place(frame);
  player_.fallTo([this](std::size_t place, float height) { patches_->set(place, height); });
  patches_->finish();
  fallen_ = player_.hasStock();
  knob_->SetPosition(bar_left + player_.share() * barLength(), bar_bottom);
  writeWords(frame);
}

/** Part, tool and machine, in the frame of the part, or if the machine is shown in the frame that stands. */
void
PlaybackPage::place(const MotionFrame& frame)
{
  const MachineStand stand(player_.time().track.kinematics(), frame.tip, frame.angles);
  const Eigen::Isometry3d part = shows_machine_ ? stand.part() : Eigen::Isometry3d::Identity();
  tool_->SetUserMatrix(matrixOf(part * stand.part().inverse() * stand.tool()));
  for (const auto& actor : patches_->actors())
    actor->SetUserMatrix(matrixOf(part));
  if (shows_machine_)
    machine_->moveTo(stand);
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
  const Kinematics& kinematics = time.track.kinematics();
  const Eigen::Vector3d gauge = kinematics.gaugePoint(kinematics.programmed(frame.tip, frame.angles));
  const Eigen::Vector3d& shown = shows_machine_ ? gauge : frame.tip;
  motion_ += formatted("   %s %.3f %.3f %.3f", shows_machine_ ? "axes X Y Z" : "tip", shown.x(), shown.y(), shown.z());
  first_->SetInput(place_.c_str());
  second_->SetInput(motion_.c_str());
}

} // namespace pcl_spiral
