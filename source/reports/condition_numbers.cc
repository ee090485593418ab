#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/condition_numbers.h>

#include <Eigen/Dense>

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// Unit vectors of the motions of a rigid body, over the free unknowns, and their names.
    std::vector<std::pair<std::string, Eigen::VectorXd>>
    rigid_motions(const Blank &blank, const Vector &q, const std::vector<int> &numbers, const int n)
    {
      std::vector<std::pair<std::string, Eigen::VectorXd>> result;
      const auto add = [&](const std::string &name, const double r, const double z, const double rotation) {
        Eigen::VectorXd v = Eigen::VectorXd::Zero(n);
        bool whole = true; // no prescribed unknown takes part
        blank.rigid_motion(q,
                           Tensor1({r, z}),
                           rotation,
                           [&](const DofIndex dof, const double value) {
                             if (value == 0.)
                               return;
                             if (numbers[dof] < 0)
                               whole = false;
                             else
                               v[numbers[dof]] = value;
                           });
        if (whole && v.norm() > 0)
          result.emplace_back(name, v.normalized());
      };
      add("translation z", 0., 1., 0.);
      if (!blank.axisymmetric())
      {
        add("translation x", 1., 0., 0.);
        add("rotation", 0., 0., 1.);
      }
      return result;
    }
  } // namespace


  ConditionReport::ConditionReport(const unsigned int every, const condition::Method method, Journal &journal,
                                   Timers &timers)
    : every_(every), method_(method), journal_(journal), timers_(timers), timer_(timers.section("14 condition numbers"))
  {
  }


  void ConditionReport::before(const Model &, const unsigned int number)
  {
    numbers_ = ConditionNumbers();
    due_ = number % every_ == 0;
  }


  void ConditionReport::tangent_without_contact(const System &system)
  {
    // Another assembly at the end would not be harmless: a rule may predict in every one, and return maps start from
    // the last one's result, so that the run would no longer be the one that was asked about.
    without_ = condition::free_matrix(system);
  }


  void ConditionReport::solved(const Model &model, const System &system, const Vector &q)
  {
    if (due_)
      numbers_ = measure(model, system, q);
  }


  void ConditionReport::accepted(const AcceptedIncrement &increment)
  {
    // A refinement gives a new matrix that nobody has measured.
    if (!due_)
      numbers_ = ConditionNumbers();
    else
      journal_.detail(
        fmt::format("increment {}: condition number {:.4g}, scaled {:.4g}; without contact {:.4g}{}",
                    increment.number,
                    numbers_.raw,
                    numbers_.scaled,
                    numbers_.without_contact,
                    numbers_.rigid_modes.empty() ? ", no rigid mode" : " apart from " + numbers_.rigid_modes));
    due_ = false;
  }


  void ConditionReport::describe(Columns &columns, const ConditionReport *const report)
  {
    columns.add({{"condition_raw", "1",
                  "condition number of the tangent as it is; empty, as all these, where it was not measured or is not "
                  "finite"},
                 {"condition_scaled", "1", "after diagonal scaling in the frames of contact"},
                 {"condition_without_contact", "1", "of the blank alone, apart from its rigid modes"},
                 {"rigid_modes", "1", "of the blank without contact"},
                 {"digits_lost", "1", "by a direct solution ([theory](theory/condition.md))"}},
                [report](const AcceptedIncrement &, Columns::Row &row) {
                  const ConditionNumbers &numbers = report->numbers_;
                  row.insert(row.end(),
                             {Columns::if_known(numbers.raw), Columns::if_known(numbers.scaled),
                              Columns::if_known(numbers.without_contact), static_cast<double>(numbers.n_rigid),
                              Columns::if_known(numbers.digits_lost)});
                });
  }


  ConditionNumbers ConditionReport::measure(const Model &model, const System &system, const Vector &q)
  {
    Timers::Scope timer(timers_, timer_);
    ConditionNumbers result;
    const std::vector<int> numbers = condition::free_numbers(system);
    condition::Matrix without;
    without.swap(without_);
    const int n = without.rows();

    // Rigid: the blank resists with less than 1e-9 of its largest stiffness. Travels of force-driven tools and
    // multipliers have no stiffness at all without contact and count as well.
    const double size = without.norm();
    std::vector<Eigen::VectorXd> modes;
    for (int i = 0; i < n; ++i)
      if (without.col(i).norm() == 0. && without.row(i).norm() == 0.)
        modes.push_back(Eigen::VectorXd::Unit(n, i));
    for (const auto &[name, mode] : rigid_motions(model.blank(), q, numbers, n))
      if ((without * mode).norm() < 1e-9 * size)
      {
        modes.push_back(mode);
        ++result.n_rigid;
        result.rigid_modes += (result.rigid_modes.empty() ? "" : ", ") + name;
      }
    Eigen::MatrixXd basis(n, modes.size());
    for (unsigned int k = 0; k < modes.size(); ++k)
      basis.col(k) = modes[k];
    if (!modes.empty())
      basis = Eigen::HouseholderQR<Eigen::MatrixXd>(basis).householderQ() * Eigen::MatrixXd::Identity(n, modes.size());
    result.without_contact = condition::number_on_complement(without, basis, method_);

    const condition::Matrix with = condition::free_matrix(system);
    result.raw = condition::number(with, method_);

    std::vector<condition::Frame> frames;
    std::vector<bool> taken(n, false);
    for (const auto *interface : model.interfaces())
      for (const auto &[r, z, normal] : interface->frames())
        if (numbers[r] >= 0 && numbers[z] >= 0 && !taken[numbers[r]])
        {
          taken[numbers[r]] = true; // a node held between two tools: they agree in the normal up to its sign
          frames.push_back({numbers[r], numbers[z], normal});
        }
    result.scaled = condition::number(condition::scale_in_frames(with, frames), method_);

    Eigen::VectorXd step(n);
    for (unsigned int i = 0; i < numbers.size(); ++i)
      if (numbers[i] >= 0)
        step[numbers[i]] = q[i] - model.committed()[i];
    result.digits_lost = condition::digits_lost(with, step);
    return result;
  }
} // namespace deltaform
