// SPDX-License-Identifier: BSD-3-Clause
#include "laplace_problem.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_for_cholesky = 300000;

using Matrix = Eigen::SparseMatrix<double>;

/** Lower half of the stiffness matrix, and the right-hand sides. */
void
assemble(const Triangulation& mesh, const std::vector<std::uint32_t>& edges, const std::vector<double>& weight,
         const LaplaceProblem& problem, Matrix& matrix, Eigen::MatrixXd& right)
{
  const auto n = static_cast<Eigen::Index>(problem.unknowns);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(edges.size() + problem.unknowns);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  right = Eigen::MatrixXd::Zero(n, problem.values.cols());
  for (const std::uint32_t h : edges) {
    const double w = weight[h], rise = problem.rise.empty() ? 0.0 : problem.rise[h];
    const std::uint32_t i = mesh.origin(h), j = mesh.target(h);
    const std::uint32_t a = problem.unknown[i], b = problem.unknown[j];
    if (a == b)
      continue;
    if (a != LaplaceProblem::known) {
      diagonal[a] += w;
      right.row(a).array() += w * rise;
      if (b == LaplaceProblem::known)
        right.row(a) += w * problem.values.row(j);
    }
    if (b != LaplaceProblem::known) {
      diagonal[b] += w;
      right.row(b).array() -= w * rise;
      if (a == LaplaceProblem::known)
        right.row(b) += w * problem.values.row(i);
    }
    if (a != LaplaceProblem::known && b != LaplaceProblem::known)
      entries.emplace_back(std::max(a, b), std::min(a, b), -w);
  }
  for (Eigen::Index i = 0; i < n; ++i)
    entries.emplace_back(i, i, diagonal[i]);
  matrix.resize(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
}

} // namespace

bool
solve(const Triangulation& mesh, const std::vector<std::uint32_t>& edges, const std::vector<double>& weight, LaplaceProblem& problem)
{
  Matrix matrix;
  Eigen::MatrixXd right, solution;
  assemble(mesh, edges, weight, problem, matrix, right);
  if (problem.unknowns <= most_for_cholesky) {
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> cholesky(matrix);
    if (cholesky.info() != Eigen::Success)
      return false;
    solution = cholesky.solve(right);
  }
  else {
    Eigen::ConjugateGradient<Matrix, Eigen::Lower, Eigen::IncompleteCholesky<double, Eigen::Lower>> gradients;
    gradients.setTolerance(1e-10);
    gradients.compute(matrix);
    if (gradients.info() != Eigen::Success)
      return false;
    solution = gradients.solve(right);
    if (gradients.info() != Eigen::Success)
      return false;
  }
  for (std::size_t i = 0; i < problem.unknown.size(); ++i)
    if (problem.unknown[i] != LaplaceProblem::known)
      problem.values.row(i) = solution.row(problem.unknown[i]);
  return solution.allFinite();
}

} // namespace pcl_spiral
