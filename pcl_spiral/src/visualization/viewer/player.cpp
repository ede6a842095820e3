// SPDX-License-Identifier: BSD-3-Clause
#include "player.h"

#include "common/formatted_text.h"
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <new>

namespace pcl_spiral {
namespace {

constexpr std::array<double, 13> speeds{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};
constexpr std::size_t most_slow = 20; // blocks to go to
constexpr double slow_share = 0.9;    // of the feed
constexpr double just_before = 1e-9;  // s

} // namespace

Player::Player(PlaybackScene scene, const VerificationScene& judged) : scene_(std::move(scene)), removal_(judged.removal_figures)
{
  input_.path = judged.part.path;
  input_.machine = scene_.program ? scene_.program->program.machine : scene_.machine;
  input_.tips = std::move(scene_.tips);
  input_.cutter = scene_.cutter;
  input_.lines = std::move(scene_.lines);
  input_.program = std::move(scene_.program);
  scene_.program.reset();
  input_.feed = scene_.feed;
  input_.control = controlModel(scene_.control, input_.machine);
}

Player::~Player()
{
  closing_ = true; // coming_ waits for its thread
}

std::string
Player::prepare()
{
  if (fault_)
    return *fault_;
  const Status status = playbackTime(input_, time_);
  fault_ = status.ok() ? std::string() : "it cannot be played: " + status.message();
  if (!status.ok())
    return *fault_;
  findSlow();
  extremes_ = axisExtremes(time_.track.program());
  coming_ = std::async(std::launch::async, [this] { return computedStock(); });
  return *fault_;
}

/** Throws nothing: the loop of the window takes the result. */
Player::Stock
Player::computedStock() const
try {
  Stock stock;
  const auto wanted = [this](double) { return !closing_; };
  if (const Status status = playbackStock(input_, scene_.left, removal_, stock.falls, wanted); !status.ok())
    stock.fault = status.message();
  else if (!closing_)
    stock.order.emplace(stock.falls);
  return stock;
}
catch (const std::bad_alloc&) {
  return {"the memory is too small", {}, {}};
}
catch (const std::exception& error) {
  return {error.what(), {}, {}};
}

void
Player::findSlow()
{
  std::vector<std::pair<double, std::size_t>> found;
  const std::vector<ProgramBlock>& blocks = time_.track.program().blocks;
  for (std::size_t b = 1; b < blocks.size(); ++b) {
    if (blocks[b].section != BlockSection::Cut)
      continue;
    const double feed = time_.track.feedIn(b), asked = time_.track.askedIn(b);
    if (asked > 0.0 && time_.track.endOf(b) > time_.track.endOf(b - 1) && feed < slow_share * asked)
      found.emplace_back(feed / asked, b);
  }
  const std::size_t count = std::min(most_slow, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
  for (std::size_t i = 0; i < count; ++i)
    slow_.push_back(found[i].second);
}

double
Player::share() const
{
  const double whole = by_length_ ? time_.track.length() : time_.track.seconds();
  return whole > 0.0 ? (by_length_ ? frame().length : seconds_) / whole : 0.0;
}

void
Player::toggle()
{
  playing_ = !playing_;
  if (playing_ && seconds_ >= time_.track.seconds())
    seek(0.0);
}

void
Player::faster(bool more)
{
  const auto now =
      std::min_element(speeds.begin(), speeds.end(), [this](double a, double b) { return std::abs(a - speed_) < std::abs(b - speed_); });
  if (more && now + 1 != speeds.end())
    speed_ = *(now + 1);
  else if (!more && now != speeds.begin())
    speed_ = *(now - 1);
}

void
Player::advance(double wall_seconds)
{
  if (!playing_)
    return;
  seek(seconds_ + speed_ * wall_seconds);
  playing_ = seconds_ < time_.track.seconds();
}

void
Player::seek(double seconds)
{
  seconds_ = std::clamp(seconds, 0.0, time_.track.seconds());
}

void
Player::seekShare(double share)
{
  const double clamped = std::clamp(share, 0.0, 1.0);
  seek(by_length_ ? time_.track.secondsAt(clamped * time_.track.length()) : clamped * time_.track.seconds());
}

void
Player::goToBlock(std::size_t block)
{
  playing_ = false;
  seek(time_.track.endOf(block) - just_before); // within it, not at the begin of the next one
}

void
Player::stepBlock(bool on)
{
  const std::size_t last = time_.track.blocks() - 1, block = frame().block;
  std::size_t next = on ? std::min(block + 1, last) : block - std::min<std::size_t>(block, 1);
  while (on && next < last && time_.track.endOf(next) <= time_.track.endOf(block)) // of no time
    ++next;
  while (!on && next > 0 && time_.track.endOf(next) <= time_.track.endOf(next - 1))
    --next;
  goToBlock(next);
}

void
Player::stepTurn(bool on)
{
  if (playsProgram() && !input_.machine.three_axes)
    return stepRotation(on);
  const pcl::PointCloud<ToolpathPoint>& path = *input_.path;
  const std::size_t i = std::min(moves(), path.size() - 1);
  const float wanted = path[i].turn + (on ? 1.0f : -1.0f);
  std::size_t next = i;
  while (on && next + 1 < path.size() && path[next].turn < wanted)
    ++next;
  while (!on && next > 0 && path[next].turn > wanted)
    --next;
  goToPoint(next);
}

/** A program knows no turns of its path: to where the first rotary axis has turned once more, or to the end. */
void
Player::stepRotation(bool on)
{
  const std::vector<ProgramBlock>& blocks = time_.track.program().blocks;
  const double from = frame().angles.first;
  std::size_t next = frame().block;
  const auto turned = [&] { return std::abs(blocks[next].angles.first - from) >= full_turn; };
  while (on && next + 1 < blocks.size() && !turned())
    ++next;
  while (!on && next > 0 && !turned())
    --next;
  goToBlock(next);
}

void
Player::goToPoint(std::size_t point)
{
  playing_ = false;
  seek(time_.reached[std::min(point, time_.reached.size() - 1)]);
}

std::string
Player::nextSlow()
{
  if (slow_.empty())
    return formatted("no block that cuts is below %g %% of its feed", 100.0 * slow_share);
  goToBlock(slow_[next_slow_]);
  const MotionFrame at = frame();
  next_slow_ = (next_slow_ + 1) % slow_.size();
  return formatted("slow: %.3g %% of the feed", 100.0 * at.feed / at.asked);
}

std::string
Player::nextWarning()
{
  if (scene_.stops.empty())
    return "no warning has a place";
  const PlaybackStop& stop = scene_.stops[next_warning_];
  next_warning_ = (next_warning_ + 1) % scene_.stops.size();
  stop.block ? goToBlock(std::min(*stop.block, time_.track.blocks() - 1)) : goToPoint(stop.point);
  return stop.words;
}

std::string
Player::nextExtreme()
{
  const AxisExtreme& at = extremes_[next_extreme_];
  next_extreme_ = (next_extreme_ + 1) % extremes_.size();
  goToBlock(at.block);
  const double unit = at.rotary ? in_degrees : 1.0;
  const char* const name = at.rotary ? "degrees" : "mm";
  return formatted("%c at its %s: %.3f %s; ", at.letter, at.largest ? "largest" : "smallest", unit * at.value, name) +
         (std::isfinite(at.limit)
              ? formatted("its limit is %.3f, %.3f %s away", unit * at.limit, unit * std::abs(at.limit - at.value), name)
              : std::string("it has no limit"));
}

bool
Player::hasStock()
{
  if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    waitForStock();
  return stock_.order.has_value();
}

bool
Player::hasNewStock()
{
  const bool awaited = coming_.valid();
  hasStock();
  return awaited && !coming_.valid();
}

void
Player::waitForStock()
{
  if (!coming_.valid())
    return;
  stock_ = coming_.get();
  heights_.assign(stock_.falls.places(), stock_.falls.reach);
  fallen_ = 0;
}

void
Player::fallTo(const std::function<void(std::size_t, float)>& changed)
{
  if (!hasStock())
    return;
  const std::size_t now = moves();
  stock_.order->update(stock_.falls, fallen_, now, heights_, [&](std::size_t place) { changed(place, heights_[place]); });
  fallen_ = now;
}

} // namespace pcl_spiral
