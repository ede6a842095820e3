// SPDX-License-Identifier: BSD-3-Clause
#include "planning/field_names.h"

namespace pcl_spiral {

const FieldNames location_names{
    {"setCeiling", "PassSettings::ceiling"}, {"setMaxRetilt", "PassSettings::max_retilt"}, {"setRetiltStep", "PassSettings::retilt_step"}};

const FieldNames ridge_names{{"setReferenceNormal", "RidgeSettings::reference"},
                             {"setMeasuringError", "RidgeSettings::measuring_error"},
                             {"setFlipNormals", "RidgeSettings::flip"},
                             {"setStepOver", "RidgeRowSettings::step_over"},
                             {"setSpot", "RidgeRowSettings::spot_size"},
                             {"setToolRadius", "RidgeRowSettings::tool_radius"},
                             {"setScallopHeight", "RidgeRowSettings::scallop_height"},
                             {"setPointSpacing", "RidgeRowSettings::point_spacing"},
                             {"setChordError", "RidgeRowSettings::chord_error"},
                             {"setStandOff", "RidgeRowSettings::stand_off"},
                             {"setLeadAngle", "RidgeRowSettings::lead"},
                             {"setTiltAngle", "RidgeRowSettings::tilt"},
                             {"setRunIn", "RidgeRowSettings::run_in"},
                             {"setRunOut", "RidgeRowSettings::run_out"},
                             {"setMaximumIterations", "RidgeLines"}};

const FieldNames tool_names{{"setCutter", "PassSettings::cutter"},
                            {"setHolder", "PassSettings::holder"},
                            {"setAcceptCollisions", "PassSettings::accept_collisions"}};

} // namespace pcl_spiral
