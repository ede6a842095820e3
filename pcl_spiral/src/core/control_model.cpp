// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/control_model.h>

#include <cmath>

namespace pcl_spiral {
namespace {

/** Measured on its planner: test/unit/oracles/linuxcnc_time.cpp. */
ControlModel
linuxcncModel()
{
  ControlModel model;
  model.corner = CornerRule::Arc;
  model.rotary_corner = CornerRule::Overlap;
  model.plans_axes = false;
  model.look_ahead = 50;
  model.cycle = 0.001;
  model.least_cycles = 1.02;
  model.gap_cycles = 4.0;
  model.arc_tangential = 0.5;
  model.arc_normal = std::sqrt(0.75); // both together are the whole acceleration
  model.kink = 0.1;
  return model;
}

/** Grbl's page of configuration: $11 = 0.010 mm. Its buffer has 16 moves. */
ControlModel
grblModel()
{
  ControlModel model;
  model.corner = model.rotary_corner = CornerRule::JunctionDeviation;
  model.plans_axes = false;
  model.stops_at_rapids = false;
  model.look_ahead = 15;
  return model;
}

/** Fanuc A-63512EN, 2.3 and 2.4: 40 blocks, the difference of speed of an axis (parameter 1783), whose value the machine builder sets. */
ControlModel
fanucModel()
{
  ControlModel model;
  model.corner = model.rotary_corner = CornerRule::AxisJump;
  model.takes_jerk = true;
  model.look_ahead = 40;
  model.jump_time = 0.004; // 8 mm/s at 2000 mm/s2: the 500 mm/min of its example
  return model;
}

/** Smoothing within tolerances of the axes (G642, G645) and acceleration with limited jerk (SOFT); the look-ahead is assumed. */
ControlModel
siemensModel()
{
  ControlModel model;
  model.corner = model.rotary_corner = CornerRule::AxisRounding;
  model.takes_jerk = true;
  model.look_ahead = 150;
  return model;
}

/** HEIDENHAIN MANUALplus 620, technical manual of January 2012, 6.16.4: up to 5000 blocks, jerk, and the tolerance of the path. */
ControlModel
heidenhainModel()
{
  ControlModel model = siemensModel();
  model.look_ahead = 5000;
  return model;
}

ControlModel
named(ControlModel model, ControlKind kind, const char* name)
{
  model.kind = kind;
  model.name = name;
  return model;
}

} // namespace

ControlModel
controlModel(ControlKind kind)
{
  switch (kind) {
  case ControlKind::LinuxCNC:
    return named(linuxcncModel(), kind, "LinuxCNC");
  case ControlKind::Grbl:
    return named(grblModel(), kind, "Grbl");
  case ControlKind::Fanuc:
    return named(fanucModel(), kind, "Fanuc");
  case ControlKind::Siemens:
    return named(siemensModel(), kind, "Siemens");
  case ControlKind::Heidenhain:
    return named(heidenhainModel(), kind, "Heidenhain");
  case ControlKind::ExactStop:
    break;
  }
  ControlModel stop;
  stop.takes_jerk = true;
  return named(stop, ControlKind::ExactStop, "exact stop");
}

std::vector<ControlModel>
controlModels()
{
  std::vector<ControlModel> models;
  for (int kind = 0; kind <= static_cast<int>(ControlKind::ExactStop); ++kind)
    models.push_back(controlModel(static_cast<ControlKind>(kind)));
  return models;
}

} // namespace pcl_spiral
