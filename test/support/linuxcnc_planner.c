/* SPDX-License-Identifier: BSD-3-Clause */
/* LinuxCNC's trajectory planner, the module tpmod, run in virtual time. In C, because the package's headers declare C. */
#include "linuxcnc_planner_calls.h"

#include <stddef.h>

#if __has_include(<linuxcnc/tp.h>)

#define ULAPI
#include <linuxcnc/motion.h>
#include <linuxcnc/tp.h>

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

/* The functions that are called; the module exports them by the names in tp.h. */
struct tp_calls {
  int (*create)(TP_STRUCT*, int, int);
  int (*set_cycle_time)(TP_STRUCT*, double);
  int (*set_vmax)(TP_STRUCT*, double, double);
  int (*set_vlimit)(TP_STRUCT*, double);
  int (*set_amax)(TP_STRUCT*, double);
  int (*set_id)(TP_STRUCT*, int);
  int (*set_pos)(TP_STRUCT*, EmcPose const*);
  int (*set_term_cond)(TP_STRUCT*, int, double);
  int (*add_line)(TP_STRUCT*, EmcPose, int, double, double, double, unsigned char, char, int, struct state_tag_t);
  int (*run_cycle)(TP_STRUCT*, long);
  int (*get_pos)(TP_STRUCT const*, EmcPose*);
  int (*get_exec_id)(TP_STRUCT*);
  int (*is_done)(TP_STRUCT*);
};

struct linuxcnc_planner {
  void* module;
  struct tp_calls call;
  emcmot_status_t* status;
  emcmot_config_t* config;
  TP_STRUCT tp;
  long period;
};

/* The module has no data of its own to pass to what it calls; all axes have the limits of one planner at a time. */
static double velocity_of[EMCMOT_MAX_AXIS];
static double acceleration_of[EMCMOT_MAX_AXIS];

static void
write_digital(int index, char value)
{
  (void)index;
  (void)value;
}

static void
write_analog(int index, double value)
{
  (void)index;
  (void)value;
}

static void
unlock_rotary(int joint, int unlock)
{
  (void)joint;
  (void)unlock;
}

static int
rotary_is_unlocked(int joint)
{
  (void)joint;
  return 1;
}

static double
velocity_limit(int axis)
{
  return velocity_of[axis];
}

static double
acceleration_limit(int axis)
{
  return acceleration_of[axis];
}

static int
find_calls(struct linuxcnc_planner* planner)
{
  const struct {
    const char* name;
    void* to;
  } wanted[] = {{"tpCreate", &planner->call.create},
                {"tpSetCycleTime", &planner->call.set_cycle_time},
                {"tpSetVmax", &planner->call.set_vmax},
                {"tpSetVlimit", &planner->call.set_vlimit},
                {"tpSetAmax", &planner->call.set_amax},
                {"tpSetId", &planner->call.set_id},
                {"tpSetPos", &planner->call.set_pos},
                {"tpSetTermCond", &planner->call.set_term_cond},
                {"tpAddLine", &planner->call.add_line},
                {"tpRunCycle", &planner->call.run_cycle},
                {"tpGetPos", &planner->call.get_pos},
                {"tpGetExecId", &planner->call.get_exec_id},
                {"tpIsDone", &planner->call.is_done}};
  for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; ++i) {
    void* const found = dlsym(planner->module, wanted[i].name);
    if (found == NULL)
      return 0;
    memcpy(wanted[i].to, &found, sizeof found);
  }
  return 1;
}

/* What the motion module sets before it runs, with the defaults of its configuration. */
static void
set_motion(struct linuxcnc_planner* planner, double cycle)
{
  emcmot_config_t* const config = planner->config;
  config->trajCycleTime = config->servoCycleTime = cycle;
  config->interpolationRate = 1;
  config->numJoints = 6;
  config->numSpindles = 1;
  config->numDIO = DEFAULT_DIO;
  config->numAIO = DEFAULT_AIO;
  config->arcBlendEnable = 1;
  config->arcBlendFallbackEnable = 0;
  config->arcBlendOptDepth = 50;
  config->arcBlendGapCycles = 4;
  config->arcBlendRampFreq = 100.0;
  config->arcBlendTangentKinkRatio = 0.1;
  config->maxFeedScale = 1.0;
  emcmot_status_t* const status = planner->status;
  status->feed_scale = status->rapid_scale = status->net_feed_scale = 1.0;
  for (int i = 0; i < EMCMOT_MAX_SPINDLES; ++i)
    status->spindle_status[i].at_speed = 1;
}

static int
connect(struct linuxcnc_planner* planner)
{
  typedef void (*functions_t)(void (*)(int, char), void (*)(int, double), void (*)(int, int), int (*)(int), double (*)(int),
                              double (*)(int));
  typedef void (*data_t)(emcmot_status_t*, emcmot_config_t*);
  functions_t functions;
  data_t data;
  void* const found[2] = {dlsym(planner->module, "tpMotFunctions"), dlsym(planner->module, "tpMotData")};
  if (found[0] == NULL || found[1] == NULL)
    return 0;
  memcpy(&functions, &found[0], sizeof functions);
  memcpy(&data, &found[1], sizeof data);
  functions(write_digital, write_analog, unlock_rotary, rotary_is_unlocked, velocity_limit, acceleration_limit);
  data(planner->status, planner->config);
  return 1;
}

static void
create(struct linuxcnc_planner* planner, const struct linuxcnc_setup* setup, const double* start)
{
  memcpy(velocity_of, setup->velocity, 6 * sizeof(double));
  memcpy(acceleration_of, setup->acceleration, 6 * sizeof(double));
  planner->period = (long)(setup->cycle * 1e9 + 0.5);
  set_motion(planner, setup->cycle);
  TP_STRUCT* const tp = &planner->tp;
  planner->call.create(tp, DEFAULT_TC_QUEUE_SIZE, 0);
  planner->call.set_cycle_time(tp, setup->cycle);
  EmcPose at;
  memset(&at, 0, sizeof at);
  at.tran.x = start[0];
  at.tran.y = start[1];
  at.tran.z = start[2];
  at.a = start[3];
  at.b = start[4];
  at.c = start[5];
  planner->call.set_pos(tp, &at);
  planner->call.set_vmax(tp, setup->largest_velocity, setup->largest_velocity);
  planner->call.set_vlimit(tp, setup->largest_velocity);
  planner->call.set_amax(tp, setup->largest_acceleration);
}

struct linuxcnc_planner*
linuxcnc_planner_new(const char* module, const struct linuxcnc_setup* setup, const double* start)
{
  struct linuxcnc_planner* const planner = calloc(1, sizeof *planner);
  planner->module = dlopen(module, RTLD_NOW | RTLD_LOCAL);
  planner->status = calloc(1, sizeof *planner->status);
  planner->config = calloc(1, sizeof *planner->config);
  if (planner->module == NULL || !find_calls(planner) || !connect(planner)) {
    linuxcnc_planner_delete(planner);
    return NULL;
  }
  create(planner, setup, start);
  return planner;
}

void
linuxcnc_planner_delete(struct linuxcnc_planner* planner)
{
  if (planner->module != NULL)
    dlclose(planner->module);
  free(planner->status);
  free(planner->config);
  free(planner);
}

int
linuxcnc_planner_add(struct linuxcnc_planner* planner, const struct linuxcnc_line* line)
{
  EmcPose end;
  memset(&end, 0, sizeof end);
  end.tran.x = line->to[0];
  end.tran.y = line->to[1];
  end.tran.z = line->to[2];
  end.a = line->to[3];
  end.b = line->to[4];
  end.c = line->to[5];
  struct state_tag_t tag;
  memset(&tag, 0, sizeof tag);
  planner->call.set_id(&planner->tp, line->id);
  planner->call.set_term_cond(&planner->tp, line->tolerance > 0.0 ? TC_TERM_COND_PARABOLIC : TC_TERM_COND_EXACT, line->tolerance);
  enum { traverse = 1, feed = 2 };
  return planner->call.add_line(&planner->tp, end, line->rapid ? traverse : feed, line->velocity, line->largest_velocity,
                                line->acceleration, 0, 0, -1, tag);
}

int
linuxcnc_planner_queued(struct linuxcnc_planner* planner)
{
  return planner->tp.queue._len; /* tpQueueDepth is brought up to date at times only */
}

int
linuxcnc_planner_cycle(struct linuxcnc_planner* planner, double* place)
{
  planner->call.run_cycle(&planner->tp, planner->period);
  EmcPose at;
  planner->call.get_pos(&planner->tp, &at);
  const double now[6] = {at.tran.x, at.tran.y, at.tran.z, at.a, at.b, at.c};
  memcpy(place, now, sizeof now);
  return planner->call.is_done(&planner->tp) ? -1 : planner->call.get_exec_id(&planner->tp);
}

int
linuxcnc_planner_built(void)
{
  return 1;
}

#else

struct linuxcnc_planner*
linuxcnc_planner_new(const char* module, const struct linuxcnc_setup* setup, const double* start)
{
  (void)module;
  (void)setup;
  (void)start;
  return NULL;
}

void
linuxcnc_planner_delete(struct linuxcnc_planner* planner)
{
  (void)planner;
}

int
linuxcnc_planner_add(struct linuxcnc_planner* planner, const struct linuxcnc_line* line)
{
  (void)planner;
  (void)line;
  return -1;
}

int
linuxcnc_planner_queued(struct linuxcnc_planner* planner)
{
  (void)planner;
  return 0;
}

int
linuxcnc_planner_cycle(struct linuxcnc_planner* planner, double* place)
{
  (void)planner;
  (void)place;
  return -1;
}

int
linuxcnc_planner_built(void)
{
  return 0;
}

#endif
