// SPDX-License-Identifier: BSD-3-Clause
// The stages at constant scallop height used again, like the other stages in reused_stages.
#include "support/reused_stage.h"

#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <pcl/console/print.h>

namespace reused_scallop_stages_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

template <typename PointT>
struct Field : StepOverField<PointT> {
  Field()
  {
    this->setToolRadius(8.0);
    this->setScallopHeight(0.2);
  }
  Values run()
  {
    this->compute(field);
    return field ? field->distance : Values();
  }
  StepOverDistance::ConstPtr field;
};

template <typename PointT>
struct Loops : ScallopLoops<PointT> {
  Loops()
  {
    this->setToolRadius(8.0);
    this->setScallopHeight(0.2);
  }
  Values run()
  {
    this->compute(set);
    Values values;
    for (const ScallopLoop& loop : set.loops)
      addLine(loop.points, values);
    return values;
  }
  ScallopLoopSet set;
};

template <typename PointT>
struct Passes : ScallopLoops<PointT> {
  Passes()
  {
    this->setToolRadius(8.0);
    this->setScallopHeight(0.2);
    this->setChordError(0.05);
  }
  Values run()
  {
    this->compute(passes);
    Values values;
    for (const DrivePass& pass : passes)
      for (const DrivePoint& point : pass.points)
        values.insert(values.end(), {point.position.x(), point.axis.y(), point.normal.z()});
    return values;
  }
  DrivePasses passes;
};

template <typename PointT>
struct Linked : LoopLinking<PointT> {
  Linked()
  {
    this->setToolRadius(8.0);
    this->setScallopHeight(0.2);
  }
  Values run()
  {
    this->compute(path);
    Values values;
    addLine(path.points, values);
    return values;
  }
  LinkedPath path;
};

class ReusedScallopStages : public testing::Test {
protected:
  ReusedScallopStages() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
};

} // namespace

TEST_F(ReusedScallopStages, Field)
{
  checkReuse<Field>("StepOverField");
}
TEST_F(ReusedScallopStages, Loops)
{
  checkReuse<Loops>("ScallopLoops");
}
TEST_F(ReusedScallopStages, Passes)
{
  checkReuse<Passes>("ScallopLoops, passes");
}
TEST_F(ReusedScallopStages, Path)
{
  checkReuse<Linked>("LoopLinking");
}

} // namespace reused_scallop_stages_test
