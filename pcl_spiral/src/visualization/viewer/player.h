// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The moment that a playback shows, and the stock there.
 */
#pragma once

#include "machine/axis_extremes.h"
#include "planning/playback.h"
#include <pcl_spiral/visualization/spiral_viewer.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Plays a path or program. The stock is computed beside it, and falls once it is there. */
class Player {
public:
  Player(PlaybackScene scene, const VerificationScene& judged);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /** Computes the times, once. Returns what is wrong; empty: nothing. */
  std::string prepare();
  /** What was given; tips, program and lines are taken out of it. */
  const PlaybackScene& scene() const { return scene_; }
  /** A program that was judged, and not one that is made of a path. After prepare. */
  bool playsProgram() const { return !time_.lines.empty(); }
  const PlaybackTime& time() const { return time_; }

  double seconds() const { return seconds_; }
  MotionFrame frame() const { return time_.track.at(seconds_); }
  double speed() const { return speed_; }
  bool playing() const { return playing_; }
  /** Of the whole, 0 to 1: of the time, or of the length. */
  double share() const;
  bool byLength() const { return by_length_; }

  /** From the begin again at the end. */
  void toggle();
  /** The next of the speeds 0.1, 0.2, 0.5, 1, ... 1000, or the one before. */
  void faster(bool more);
  void advance(double wall_seconds);
  void seek(double seconds);
  void seekShare(double share);
  void toggleLength() { by_length_ = !by_length_; }
  void stepBlock(bool on);
  /** To where the path has made one turn or pass more, or less; for a program on five axes one turn of the first rotary axis. */
  void stepTurn(bool on);
  void goToPoint(std::size_t point);
  void goToBlock(std::size_t block);
  /** The next of the blocks that cut slowest against their feed; what it is in words. */
  std::string nextSlow();
  /** The next of the scene's warnings; its words. */
  std::string nextWarning();
  /** To where an axis is at its smallest or largest value, one after the other: the value beside its limit. */
  std::string nextExtreme();

  /** Moves of the path that are complete. */
  std::size_t moves() const { return movesAfter(time_, seconds_); }
  /** Whether the stock is known by now. */
  bool hasStock();
  /** Whether it has become known with this call, or why there is none. */
  bool hasNewStock();
  /** Waits until it is. */
  void waitForStock();
  /** Why there is no stock; empty: there is, or it is being computed. */
  const std::string& stockFault() const { return stock_.fault; }
  /** Lets the stock fall to what it is at this moment; calls \p changed(place, height). */
  void fallTo(const std::function<void(std::size_t, float)>& changed);

private:
  /** What is computed beside the playback. */
  struct Stock {
    std::string fault;
    StockFalls falls;
    std::optional<FallOrder> order; ///< absent: no stock
  };
  Stock computedStock() const;
  void findSlow();
  void stepRotation(bool on);

  PlaybackScene scene_;
  PlaybackInput input_;
  RemovalReport removal_;
  PlaybackTime time_;
  std::optional<std::string> fault_; ///< of prepare
  double seconds_ = 0.0, speed_ = 1.0;
  bool playing_ = false, by_length_ = false;
  std::vector<std::size_t> slow_; ///< blocks
  std::vector<AxisExtreme> extremes_;
  std::size_t next_slow_ = 0, next_warning_ = 0, next_extreme_ = 0;
  std::atomic<bool> closing_{false}; ///< the stock is no longer wanted
  std::future<Stock> coming_;
  Stock stock_;
  std::vector<float> heights_;
  std::size_t fallen_ = 0; ///< moves
};

} // namespace pcl_spiral
