// SPDX-License-Identifier: BSD-3-Clause
#include "harmonic_field.h"

#include "edge_weights.h"
#include "harmonic_domain.h"
#include "laplace_problem.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

using Edge = HarmonicDomain::Edge;

/** Points of the domain get numbers of their own; the others are known, and their values are never used. */
LaplaceProblem
problemOn(const Triangulation& mesh, const HarmonicDomain& domain, std::size_t points, int columns)
{
  LaplaceProblem problem;
  problem.unknown.assign(points, LaplaceProblem::known);
  problem.values = Eigen::MatrixXd::Constant(points, columns, std::numeric_limits<double>::quiet_NaN());
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (domain.kind[h] != Edge::Elsewhere)
      problem.unknown[mesh.origin(h)] = 0;
  return problem;
}

/** Number the points marked 0 in order. */
void
number(LaplaceProblem& problem)
{
  for (std::uint32_t& id : problem.unknown)
    if (id != LaplaceProblem::known)
      id = static_cast<std::uint32_t>(problem.unknowns++);
}

void
setKnown(LaplaceProblem& problem, std::uint32_t point, const Eigen::RowVectorXd& values)
{
  problem.unknown[point] = LaplaceProblem::known;
  problem.values.row(point) = values;
}

} // namespace

HarmonicField::HarmonicField() = default;
HarmonicField::~HarmonicField() = default;
HarmonicField::HarmonicField(HarmonicField&&) noexcept = default;
HarmonicField& HarmonicField::operator=(HarmonicField&&) noexcept = default;

Status
HarmonicField::compute(const SurfaceGraph& graph, const Eigen::Vector3d& centre, const std::vector<std::uint32_t>& rim_points)
{
  *this = HarmonicField();
  auto domain = std::make_unique<HarmonicDomain>();
  const Status status = makeDomain(graph, centre, rim_points, *domain);
  if (!status.ok())
    return status;
  graph_ = &graph;
  domain_ = std::move(domain);
  return solveFields({}, rim_points);
}

Status
HarmonicField::compute(const SurfaceGraph& graph, const std::vector<std::uint32_t>& inner_points, const Polyline& inner_curve,
                       const std::vector<std::uint32_t>& rim_points)
{
  *this = HarmonicField();
  if (inner_curve.size() < 3)
    return {StatusCode::InvalidArgument, Diagnostic("the inner curve has ", inner_curve.size(), " points: give the closed inner outline")};
  auto domain = std::make_unique<HarmonicDomain>();
  Status status = makeDomain(graph, inner_points, rim_points, *domain);
  if (!status.ok())
    return status;
  graph_ = &graph;
  domain_ = std::move(domain);
  status = solveFields(inner_points, rim_points);
  if (status.ok())
    levelInnerCurve(inner_curve);
  return status;
}

Status
HarmonicField::solveFields(const std::vector<std::uint32_t>& inner_points, const std::vector<std::uint32_t>& rim_points)
{
  const std::vector<double> weight = edgeWeights(*graph_);
  bool height_done = false, angle_done = false;
#pragma omp parallel sections
  {
#pragma omp section
    height_done = solveHeight(weight, inner_points, rim_points);
#pragma omp section
    angle_done = solveAngle(weight);
  }
  if (!height_done || !angle_done) {
    *this = HarmonicField();
    return {StatusCode::Failed, "the equations of the harmonic function could not be solved: the surface between the "
                                "middle and the rim is almost disconnected; close the gaps, or thin less"};
  }
  levelRim();
  surface_ = std::make_unique<MlsSurface>(*graph_);
  return Status::success();
}

bool
HarmonicField::solveHeight(const std::vector<double>& weight, const std::vector<std::uint32_t>& inner_points,
                           const std::vector<std::uint32_t>& rim_points)
{
  const Triangulation& mesh = graph_->triangulation();
  const HarmonicDomain& domain = *domain_;
  // Two solutions: from 0 in the middle to 1 on the rim, and from log r in the disc to 0 on the rim.
  LaplaceProblem problem = problemOn(mesh, domain, graph_->size(), 2);
  const auto fix = [&](std::uint32_t point, double first, double second) { setKnown(problem, point, Eigen::RowVector2d(first, second)); };
  for (const std::uint32_t i : inner_points)
    fix(i, 0.0, 0.0);
  for (std::size_t k = 0; k < domain.disc.size(); ++k)
    fix(domain.disc[k], 0.0, std::log(std::max(domain.disc_radius[k], 0.1)));
  for (const std::uint32_t i : rim_points)
    fix(i, 1.0, 0.0);
  number(problem);
  if (!solve(mesh, domain.edges, weight, problem))
    return false;
  // u = first + b second, with b such that u rises like b log r about the centre: its flux into the rim is 2 pi b.
  Eigen::RowVector2d flux = Eigen::RowVector2d::Zero();
  for (std::uint32_t h : domain.edges) {
    const std::uint32_t i = mesh.origin(h), j = mesh.target(h);
    if (domain.in_disc[i] != domain.in_disc[j])
      flux += (domain.in_disc[i] ? 1.0 : -1.0) * weight[h] * (problem.values.row(j) - problem.values.row(i));
  }
  const double b = domain.disc.empty() ? 0.0 : flux[0] / (2.0 * pi - flux[1]);
  height_.resize(graph_->size());
  for (std::size_t i = 0; i < height_.size(); ++i) {
    const double u = problem.values(i, 0) + b * problem.values(i, 1);
    height_[i] = std::isnan(u) ? u : std::clamp(u, 0.0, 1.0);
  }
  return true;
}

bool
HarmonicField::solveAngle(const std::vector<double>& weight)
{
  const Triangulation& mesh = graph_->triangulation();
  const HarmonicDomain& domain = *domain_;
  LaplaceProblem problem = problemOn(mesh, domain, graph_->size(), 1);
  problem.rise.assign(mesh.halfEdgeCount(), 0.0);
  for (std::size_t h = 0; h < problem.rise.size(); ++h)
    problem.rise[h] = 2.0 * pi * domain.cut[h];
  if (domain.disc.empty()) // any constant may be added
    setKnown(problem, mesh.origin(domain.rim[0]), Eigen::RowVectorXd::Zero(1));
  for (std::size_t k = 0; k < domain.disc.size(); ++k)
    setKnown(problem, domain.disc[k], Eigen::RowVectorXd::Constant(1, domain.disc_angle[k]));
  number(problem);
  // Nothing flows through the edge of a gap: v is constant along it. Gaps that touch share the constant.
  for (bool changed = !domain.gaps.empty(); changed;) {
    changed = false;
    for (const auto& gap : domain.gaps) {
      std::uint32_t least = LaplaceProblem::known;
      for (const std::uint32_t h : gap)
        least = std::min(least, problem.unknown[mesh.origin(h)]);
      for (const std::uint32_t h : gap) {
        std::uint32_t& id = problem.unknown[mesh.origin(h)];
        if (id != LaplaceProblem::known && id != least) {
          id = least;
          changed = true;
        }
      }
    }
  }
  std::vector<std::uint32_t> rank(problem.unknowns, LaplaceProblem::known);
  problem.unknowns = 0;
  for (std::uint32_t& id : problem.unknown)
    if (id != LaplaceProblem::known) {
      if (rank[id] == LaplaceProblem::known)
        rank[id] = static_cast<std::uint32_t>(problem.unknowns++);
      id = rank[id];
    }
  if (!solve(mesh, domain.edges, weight, problem))
    return false;
  angle_.assign(problem.values.data(), problem.values.data() + problem.values.rows());
  return true;
}

double
HarmonicField::growth(std::uint32_t half_edge) const
{
  const Triangulation& mesh = graph_->triangulation();
  return angle_[mesh.target(half_edge)] - angle_[mesh.origin(half_edge)] + 2.0 * pi * domain_->cut[half_edge];
}

void
HarmonicField::levelRim()
{
  rim_angle_.assign(1, angle_[graph_->triangulation().origin(domain_->rim[0])]);
  for (const std::uint32_t h : domain_->rim)
    rim_angle_.push_back(rim_angle_.back() + growth(h));
  for (std::size_t i = 1; i < rim_angle_.size(); ++i) // rounding
    rim_angle_[i] = std::max(rim_angle_[i], rim_angle_[i - 1]);
}

} // namespace pcl_spiral
