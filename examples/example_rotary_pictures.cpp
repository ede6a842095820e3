// SPDX-License-Identifier: BSD-3-Clause
// Makes column_angles.png of pcl_spiral/doc/drive.md in the current folder: the rotary angles along a helix round the column of
// pcl_spiral_simulate_scan, with axes of local planes and of the cylinder. xvfb-run -a example_rotary_pictures column.pcd
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/visualization/add_toolpath.h>
#include <pcl_spiral/visualization/pictures.h>

#include <vtkAutoInit.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkFloatArray.h>
#include <vtkPlot.h>
#include <vtkTable.h>

VTK_MODULE_INIT(vtkRenderingContextOpenGL2);
using namespace pcl_spiral;
using Viewer = pcl::visualization::PCLVisualizer;

constexpr double in_degrees = 180.0 / M_PI;

/** One pass of a ball, with locations added until its moves keep the tolerance. */
static ToolLocations
helix(const Scan& scan, DriveAxisMode mode)
{
  DrivePath<pcl::PointXYZ> drive;
  drive.setInputCloud(scan.cloud);
  drive.setKind(DriveKind::Helix);
  drive.setAxisMode(mode);
  drive.setStepOver(1.0);
  drive.setPointSpacing(0.5);
  drive.setOverrun(2.0);
  DrivePasses passes;
  drive.compute(passes);
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(scan.cloud);
  location.setCutter(CutterShape::ball(4.0));
  location.setDrivePasses(passes);
  location.setPathTolerance(0.01);
  ToolLocations locations;
  location.compute(locations);
  return locations;
}

/** Charts of a fork head's angles, C about z and B about y carried by it, over two turns of the helix. */
static void
addCharts(Viewer& viewer, int row, const std::string& axes, const ToolLocations& pass)
{
  vtkNew<vtkFloatArray> way, b, c;
  double arc = 0.0, turned = 0.0, largest[2]{};
  for (std::size_t i = 1; i < pass.size(); ++i) {
    const Eigen::Vector3d &from = pass[i - 1].axis, &to = pass[i].axis;
    const double step = std::remainder(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()), 2.0 * M_PI) * in_degrees;
    arc += (pass[i].tip - pass[i - 1].tip).norm();
    turned += step;
    largest[0] = std::max(largest[0], std::abs(std::acos(to.z()) - std::acos(from.z())) * in_degrees);
    largest[1] = std::max(largest[1], std::abs(step));
    if (turned < 20 * 360.0 || turned > 22 * 360.0)
      continue;
    way->InsertNextValue(static_cast<float>(arc));
    b->InsertNextValue(static_cast<float>(std::acos(to.z()) * in_degrees));
    c->InsertNextValue(static_cast<float>(turned - 20 * 360.0));
  }
  vtkNew<vtkContextActor> actor;
  for (int k : {0, 1}) {
    vtkNew<vtkTable> table;
    table->AddColumn(way);
    table->AddColumn(k == 0 ? b : c);
    table->GetColumn(0)->SetName("path, mm");
    table->GetColumn(1)->SetName("angle");
    vtkNew<vtkChartXY> chart;
    chart->SetAutoSize(false);
    chart->SetSize(vtkRectf(10.0f + 790.0f * k, 10.0f + 450.0f * row, 770.0f, 430.0f));
    chart->SetTitle(axes + (k == 0 ? ": B" : ": C") + ", degrees; largest step " + std::to_string(largest[k]).substr(0, 4));
    chart->GetAxis(vtkAxis::LEFT)->SetTitle("");
    chart->GetAxis(vtkAxis::BOTTOM)->SetTitle("length of the path, mm");
    chart->GetAxis(vtkAxis::LEFT)->SetBehavior(vtkAxis::FIXED);
    chart->GetAxis(vtkAxis::LEFT)->SetRange(k == 0 ? 60.0 : 0.0, k == 0 ? 120.0 : 720.0);
    vtkPlot* line = chart->AddPlot(vtkChart::LINE);
    line->SetInputData(table, 0, 1);
    line->SetColor(25, 56, 168, 255);
    actor->GetScene()->AddItem(chart);
    std::printf("%s\n", chart->GetTitle().c_str());
  }
  vtkRenderer* view = viewer.getRendererCollection()->GetFirstRenderer();
  view->AddActor(actor);
  actor->GetScene()->SetRenderer(view);
}

int
main(int argc, char** argv)
{
  if (const std::string fault = displayFault(); argc != 2 || !fault.empty()) // without a display PCLVisualizer would end the program
    return std::fprintf(stderr, "usage: xvfb-run -a %s column.pcd; %s\n", argv[0], fault.c_str());
  const Scan scan = readCloud(argv[1]);
  Viewer viewer("angles");
  viewer.setSize(1600, 920);
  viewer.setBackgroundColor(1.0, 1.0, 1.0);
  viewer.setShowFPS(false);
  addCharts(viewer, 1, "axes of local planes", helix(scan, DriveAxisMode::LocalPlane));
  addCharts(viewer, 0, "axes of the cylinder", helix(scan, DriveAxisMode::Cylinder));
  viewer.spinOnce();
  viewer.saveScreenshot("column_angles.png");
  return 0;
}
