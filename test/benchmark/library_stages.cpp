// SPDX-License-Identifier: BSD-3-Clause
#include "library_stages.h"

#include "core/smooth_axes.h"
#include "core/tilted_axes.h"
#include "search/neighbour_search.h"
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <pcl/io/pcd_io.h>

#include <unistd.h>

#include <filesystem>

namespace pcl_spiral::benchmarks {

namespace {

using State = benchmark::State;

constexpr int knn = 32;
constexpr std::size_t chunk = 1u << 16; // path points that the planner projects at once

/** A temporary file, removed at the end. */
class ScratchFile {
public:
  explicit ScratchFile(const std::string& extension)
  : path_(std::filesystem::temp_directory_path() / ("pcl_spiral_benchmark_" + std::to_string(::getpid()) + extension))
  {}
  ~ScratchFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }
  std::size_t size() const { return std::filesystem::file_size(path_); }

private:
  std::filesystem::path path_;
};

std::size_t
bytesOf(std::size_t points)
{
  return points * sizeof(Eigen::Vector3f);
}

void
readPcd(State& state, StageInput& input, int)
{
  const ScratchFile file(".pcd");
  pcl::io::savePCDFileBinary(file.path(), *input.cloud(FileOrder::Random));
  for (auto _ : state)
    benchmark::DoNotOptimize(readCloud(file.path()));
  count(state, input.points().size(), file.size());
}

template <FileOrder order>
void
spatialSort(State& state, StageInput& input, int)
{
  const Points& points = input.points(order);
  for (auto _ : state)
    benchmark::DoNotOptimize(PointBlocks(points));
  count(state, points.size(), bytesOf(points.size()));
}

/** The lower limit for all stages with neighbourhoods: only the search. */
void
bareKnn(State& state, StageInput& input, int)
{
  const PointBlocks& blocks = input.graph().blocks();
  std::vector<float> radii(blocks.size());
  const auto block_count = static_cast<std::int64_t>(blocks.blockCount());
  for (auto _ : state) {
#pragma omp parallel
    {
      NeighbourSearch search(blocks, knn);
#pragma omp for schedule(dynamic, 16)
      for (std::int64_t b = 0; b < block_count; ++b) {
        search.setRun(blocks.blockBox(b));
        for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i)
          radii[i] = search.find(blocks.position(i)).squared_distance[knn - 1];
      }
    }
    benchmark::DoNotOptimize(radii.data());
  }
  count(state, blocks.size(), bytesOf(blocks.size()));
}

template <FileOrder order>
void
fusedPass(State& state, StageInput& input, int)
{
  const Points& points = input.points(order);
  for (auto _ : state) {
    SurfaceGraph graph;
    require(graph.build(points, SurfaceGraphOptions()));
    benchmark::DoNotOptimize(graph);
  }
  count(state, points.size(), bytesOf(points.size()));
}

void
noiseEstimate(State& state, StageInput& input, int)
{
  const SurfaceGraph& graph = input.graph();
  for (auto _ : state)
    benchmark::DoNotOptimize(MlsSurface(graph));
  count(state, graph.size(), bytesOf(graph.size()));
}

void
boundaryLoops(State& state, StageInput& input, int)
{
  const MlsSurface& surface = input.surface();
  for (auto _ : state) {
    std::vector<BoundaryLoop> loops;
    require(findBoundaryLoops(surface, BoundaryOptions(), loops));
    benchmark::DoNotOptimize(loops);
  }
  count(state, input.graph().size(), bytesOf(input.graph().size()));
}

void
distanceField(State& state, StageInput& input, int)
{
  const SurfaceGraph& graph = input.graph();
  for (auto _ : state) {
    DistanceField field;
    benchmark::DoNotOptimize(field.compute(graph, input.centre()));
  }
  count(state, graph.size(), bytesOf(graph.size()));
}

/** The refinement of 128 radial lines of a spiral. */
void
refinement(State& state, StageInput& input, int)
{
  const MlsSurface& surface = input.surface();
  const std::vector<GeodesicLine>& traces = input.traces();
  RefinementOptions options;
  options.levels = {32, 128};
  options.max_iterations = 8;
  options.probe_normals = false;
  options.tolerance = 2e-4;
  for (auto _ : state) {
    std::vector<GeodesicLine> lines = traces;
    refineGeodesics(surface, options, lines);
    benchmark::DoNotOptimize(lines);
  }
  const std::size_t points = traces.size() * static_cast<std::size_t>(options.levels.back());
  count(state, points, points * sizeof(Eigen::Vector3d));
}

void
projection(State& state, StageInput& input, int)
{
  const MlsSurface& surface = input.surface();
  const Polyline& spiral = input.spiral();
  std::vector<SurfaceFoot> feet;
  for (auto _ : state)
    for (std::size_t begin = 0; begin < spiral.size(); begin += chunk) {
      const auto first = spiral.begin() + static_cast<std::ptrdiff_t>(begin);
      surface.project({first, first + static_cast<std::ptrdiff_t>(std::min(chunk, spiral.size() - begin))}, feet);
      benchmark::DoNotOptimize(feet.data());
    }
  count(state, spiral.size(), spiral.size() * sizeof(Eigen::Vector3d));
}

void
toolAxis(State& state, StageInput& input, int)
{
  const Polyline& spiral = input.spiral();
  std::vector<Eigen::Vector3d> normals;
  for (const SurfaceFoot& foot : input.spiralFeet())
    normals.push_back(foot.normal);
  constexpr double degree = M_PI / 180.0;
  for (auto _ : state)
    benchmark::DoNotOptimize(smoothAxes(spiral, tiltedAxes(spiral, normals, 15.0 * degree, 0.0), {50.0, 2.0 * degree, 10.0 * degree}));
  count(state, spiral.size(), 2 * spiral.size() * sizeof(Eigen::Vector3d));
}

/** A tapered bull-nose on up to 100,000 places of the spiral, tilted 15 degrees; the time includes making the
 *  surface. */
template <int radius>
void
cutterLocation(State& state, StageInput& input, int threads)
{
  const std::vector<SurfaceFoot>& feet = input.spiralFeet();
  const std::size_t places = std::min<std::size_t>(100000, feet.size());
  DrivePoints drive;
  for (std::size_t k = 0; k < places; ++k) {
    const SurfaceFoot& foot = feet[k * feet.size() / places];
    drive.push_back({foot.position, tiltedAxis(foot.normal, foot.direction1, 15.0 * M_PI / 180.0, 0.0), foot.normal});
  }
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(input.cloud(FileOrder::Random));
  location.setCutter(CutterShape::taperedBullNose(radius, 0.2 * radius, 2.0 * radius, 10.0));
  location.setDrivePoints(drive);
  location.setNumberOfThreads(threads);
  ToolLocations locations;
  for (auto _ : state) {
    location.compute(locations);
    require(location.getStatus());
    benchmark::DoNotOptimize(locations.data());
  }
  count(state, places, places * sizeof(ToolLocation));
  state.counters["on_surface"] =
      static_cast<double>(location.getReport().count(LocationBasis::FittedSurface)) / static_cast<double>(places);
}

void
writeCsv(State& state, StageInput& input, int)
{
  const ScratchFile file(".csv");
  for (auto _ : state)
    writeToolpathCSV(file.path(), input.path(), {10.0, 1000.0});
  count(state, input.path().size(), file.size());
}

} // namespace

void
count(State& state, std::size_t items, std::size_t bytes)
{
  const auto iterations = static_cast<std::int64_t>(state.iterations());
  state.SetItemsProcessed(iterations * static_cast<std::int64_t>(items));
  state.SetBytesProcessed(iterations * static_cast<std::int64_t>(bytes));
}

std::vector<Stage>
libraryStages()
{
  return {{"read_pcd", readPcd},
          {"spatial_sort", spatialSort<FileOrder::Random>},
          {"spatial_sort_sorted_file", spatialSort<FileOrder::Sorted>},
          {"bare_knn", bareKnn},
          {"fused_pass", fusedPass<FileOrder::Random>},
          {"fused_pass_sorted_file", fusedPass<FileOrder::Sorted>},
          {"noise_estimate", noiseEstimate},
          {"boundary_loops", boundaryLoops},
          {"distance_field", distanceField},
          {"refinement", refinement},
          {"projection", projection},
          {"tool_axis", toolAxis},
          {"cutter_location", cutterLocation<10>},
          {"cutter_location_wide", cutterLocation<60>},
          {"write_csv", writeCsv}};
}

} // namespace pcl_spiral::benchmarks
