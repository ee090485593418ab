// Assembly of a solid by a plain loop and by WorkStream on one and two threads: microseconds per cell. Prints Markdown.
// The cells do what a cell of degree 2 does: nine material updates, the tangent, and adding it to a sparse matrix.
#include <deltaform/kinematics/logarithmic_strain.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/point_history.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include "../../source/blanks/solid_tangent.h"

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/work_stream.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <chrono>
#include <cstdio>

using namespace deltaform;

namespace
{
  constexpr unsigned int n_nodes = 9, n_points = 9, n = 2 * n_nodes;
  using Tangent = SolidTangent<n_nodes, n_points>;

  struct Scratch
  {
  };

  struct Copy
  {
    std::array<double, n * n> matrix;
    std::vector<dealii::types::global_dof_index> dofs = std::vector<dealii::types::global_dof_index>(n);
  };

  /// A strip of cells, and what it takes to assemble it.
  class Strip
  {
  public:
    explicit Strip(const unsigned int along)
      : dof_handler_(triangulation_), element_(dealii::FE_Q<2>(2), 2), strain_(2 * along * n_points)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(
        triangulation_, {along, 2u}, dealii::Point<2>(0, 0), dealii::Point<2>(along, 2));
      dof_handler_.distribute_dofs(element_);
      dealii::DynamicSparsityPattern pattern(dof_handler_.n_dofs());
      dealii::DoFTools::make_sparsity_pattern(dof_handler_, pattern);
      pattern_.copy_from(pattern);
      matrix_.reinit(pattern_);
      ParameterTree tree = ParameterTree::parse("",
                                                "benchmark",
                                                {"Material/Hardening/Strength coefficient=589",
                                                 "Material/Young's modulus=69004",
                                                 "Material/Poisson's ratio=.3",
                                                 "Material/Hardening/Prestrain=1e-4",
                                                 "Material/Hardening/Hardening exponent=.216"});
      Section section = tree.root().sub("Material");
      material_ = Registry<Material>::make("elastoplastic", section);
      history_ = PointHistory(strain_.size(), material_->history_layout());
      for (unsigned int p = 0; p < n_points; ++p)
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          gradients_[p].r[a] = .1 * (a + p) - .8;
          gradients_[p].z[a] = .05 * a * (p % 3) - .3;
          gradients_[p].t[a] = .01;
        }
      project_.fill(1. / n_points);
    }

    /// Microseconds per cell, the least of some passes.
    template <class Loop>
    double measure(const Loop &loop)
    {
      double least = 1e300;
      for (unsigned int repetition = 0; repetition < 30; ++repetition)
      {
        matrix_ = 0.;
        const auto start = std::chrono::steady_clock::now();
        loop();
        const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count() / triangulation_.n_active_cells());
      }
      return least;
    }

    double plain()
    {
      return measure(
        [&]() {
          Scratch scratch;
          Copy copy;
          for (const auto &cell : dof_handler_.active_cell_iterators())
          {
            work(cell, scratch, copy);
            add(copy);
          }
        });
    }

    double work_stream(const unsigned int chunk)
    {
      return measure(
        [&]() {
          dealii::WorkStream::run(
            dof_handler_.begin_active(),
            dof_handler_.end(),
            [&](const Cell &cell, Scratch &scratch, Copy &copy) { work(cell, scratch, copy); },
            [&](const Copy &copy) { add(copy); },
            Scratch(),
            Copy(),
            2 * dealii::MultithreadInfo::n_threads(),
            chunk);
        });
    }

  private:
    using Cell = dealii::DoFHandler<2>::active_cell_iterator;

    void work(const Cell &cell, Scratch &, Copy &copy)
    {
      const unsigned int first = cell->active_cell_index() * n_points;
      std::array<double, 16 * n_points> moduli;
      std::array<Mandel, n_points> stress;
      for (unsigned int p = 0; p < n_points; ++p)
        strain_[first + p] = {{.02 + .001 * p, -.01, -.01, .003}};
      MaterialBatch batch;
      batch.n_points = n_points;
      batch.third_direction = ThirdDirection::strain_given;
      batch.strain = &strain_[first];
      batch.committed = history_.committed(first);
      batch.trial = history_.trial(first);
      batch.stress = stress.data();
      batch.tangent = moduli.data();
      if (!material_->update(batch).good())
        std::puts("the material has failed");
      Tangent tangent(gradients_);
      tangent.project_volume(project_.data());
      std::array<double, n_points> weight;
      weight.fill(1.);
      std::array<Tangent::Stress, n_points> tau;
      for (unsigned int p = 0; p < n_points; ++p)
      {
        const AxialTensor b{1.1, .9, 1., .01 * p};
        const Mandel e = LogarithmicStrain::strain(b);
        tau[p] = {stress[p][0], stress[p][1], stress[p][2], e[3]};
        tangent.set_stress_rate(p, &moduli[16 * p], LogarithmicStrain::rate(b));
      }
      tangent.assemble(project_.data(), weight, tau, copy.matrix.data());
      cell->get_dof_indices(copy.dofs);
    }

    void add(const Copy &copy)
    {
      for (unsigned int i = 0; i < n; ++i)
        matrix_.add(copy.dofs[i], n, copy.dofs.data(), &copy.matrix[i * n]);
    }

    dealii::Triangulation<2> triangulation_;
    dealii::DoFHandler<2> dof_handler_;
    dealii::FESystem<2> element_;
    dealii::SparsityPattern pattern_;
    dealii::SparseMatrix<double> matrix_;
    std::unique_ptr<Material> material_;
    PointHistory history_;
    std::vector<Mandel> strain_;
    Tangent::AllGradients gradients_;
    std::array<double, n_points * n_points> project_{};
  };
} // namespace

int
main()
{
  std::puts("| cells | plain loop | WorkStream, 1 thread | 2 threads, chunks of 8 | 2 threads, chunks of 64 "
            "|\n|---|---|---|---|---|");
  for (const unsigned int along : {100u, 400u, 3200u})
  {
    Strip strip(along);
    dealii::MultithreadInfo::set_thread_limit(1);
    const double plain = strip.plain(), one = strip.work_stream(8);
    dealii::MultithreadInfo::set_thread_limit(2);
    const double small = strip.work_stream(8), large = strip.work_stream(64);
    std::printf("| %u | %.2f | %.2f | %.2f | %.2f |\n", 2 * along, plain, one, small, large);
  }
  return 0;
}
