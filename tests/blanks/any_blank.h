#pragma once
// Every registered blank in every variant that its scene section offers.
#include "../materials/material_point.h"
#include "dense_target.h"

#include <deltaform/blanks/blank.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include <random>

namespace deltaform
{
  namespace testing
  {
    /// A registered blank with the parameters of its documentation, changed by @p overrides "Section/entry=value".
    inline std::unique_ptr<Blank> make_blank(const std::string &name, const Entries &overrides)
    {
      Entries entries = documented_entries(
        [&](ParameterTree &tree) {
          Section section = tree.root().sub("Blank");
          Registry<Blank>::make(name, section);
        });
      entries.insert(entries.end(), overrides.begin(), overrides.end());
      ParameterTree tree = ParameterTree::parse("", "test", entries);
      Section section = tree.root().sub("Blank");
      return Registry<Blank>::make(name, section);
    }

    /// A blank with a curved meridian from the axis; entries that a blank does not know do not hurt.
    inline Entries curved(const Entries &more = {})
    {
      Entries result = {"Blank/Points=0 .2; .6 .35; 1 -.1",
                        "Blank/Fillet radii=0, .2, 0",
                        "Blank/Thickness=.04",
                        "Blank/Elements=6",
                        "Blank/Layers=5",
                        "Material/Young's modulus=2e3"};
      result.insert(result.end(), more.begin(), more.end());
      return result;
    }

    inline const Entries elastic = {"Material/Model=linear elastic"};
    inline const Entries plastic = {"Material/Model=elastoplastic",
                                    "Material/Hardening/Law=linear",
                                    "Material/Hardening/Initial flow stress=4",
                                    "Material/Hardening/Hardening modulus=20"};

    /// @p body for every registered blank, degree, symmetry, bending or not, and contact point that go together.
    inline void for_all_blanks(const Entries &base, const std::function<void(Blank &, const Entries &)> &body)
    {
      for (const auto &name : Registry<Blank>::names())
      {
        unsigned int n_made = 0;
        for (const std::string degree : {"1", "2"})
          for (const std::string symmetry : {"axisymmetric", "plane strain"})
            for (const std::string membrane : {"false", "true"})
              for (const std::string point : {"point=normal offset", "point=outer fibre", "points=gauss"})
              {
                Entries entries = base;
                entries.insert(entries.end(),
                               {"Blank/Degree=" + degree,
                                "Blank/Symmetry=" + symmetry,
                                "Blank/Membrane=" + membrane,
                                "Blank/Contact " + point});
                std::unique_ptr<Blank> blank;
                try
                {
                  blank = make_blank(name, entries);
                }
                catch (const SceneError &error)
                {
                  BOOST_TEST(std::string(error.what()).find("Contact point") != std::string::npos, error.what());
                  continue; // what does not go together
                }
                ++n_made;
                BOOST_TEST_CONTEXT(name << ", degree " << degree << ", " << symmetry << ", membrane " << membrane
                                        << ", " << point)
                body(*blank, entries);
              }
        BOOST_TEST(n_made >= 8);
      }
    }

    inline std::vector<double> scales(const Blank &blank)
    {
      std::vector<double> result;
      for (unsigned int i = 0; i < blank.n_dofs(); ++i)
        result.push_back(blank.dof_scale(i));
      return result;
    }

    /// 1, or less where nodes are so close that cells would turn inside out by displacements that other blanks bear.
    inline double fineness(const Blank &blank)
    {
      const auto X = blank.positions(Vector(blank.n_dofs()));
      double nearest = 1.;
      for (unsigned int i = 0; i < X.size(); ++i)
        for (unsigned int j = 0; j < i; ++j)
          nearest = std::min(nearest, X[i].distance(X[j]));
      return nearest < .05 ? 5. * nearest : 1.;
    }

    /// Displacements of about @p size times fineness() and rotations of about ten times as much (rad), none where they
    /// are fixed.
    inline Vector random_state(const Blank &blank, std::mt19937 &generator, double size)
    {
      size *= fineness(blank);
      std::uniform_real_distribution<double> uniform(-size, size);
      Vector q(blank.n_dofs());
      for (unsigned int i = 0; i < q.size(); ++i)
        q[i] = uniform(generator) * (blank.dof_scale(i) == 1. ? 1. : 10.);
      for (const auto dof : blank.fixed_dofs())
        q[dof] = 0.;
      return q;
    }

    inline void assemble(Blank &blank, const Vector &q, AssemblyTarget &target)
    {
      const Status status = blank.assemble(q, target);
      BOOST_TEST_REQUIRE(status.good(), status.cause);
    }

    inline Assembly internal_forces(Blank &blank)
    {
      return [&](const Vector &q, AssemblyTarget &target) { assemble(blank, q, target); };
    }

    inline Eigen::VectorXd residual(Blank &blank, const Vector &q)
    {
      DenseTarget target(blank.n_dofs(), false);
      assemble(blank, q, target);
      return target.residual;
    }

    /// What an unknown does: which node it moves along which axis, or nothing that moves a node (a rotation).
    struct DofRole
    {
      unsigned int node = invalid_index, axis = 0;
    };

    /// Found by moving each unknown alone.
    inline std::vector<DofRole> roles(const Blank &blank)
    {
      std::vector<DofRole> result(blank.n_dofs());
      const auto start = blank.positions(Vector(blank.n_dofs()));
      for (unsigned int i = 0; i < blank.n_dofs(); ++i)
      {
        Vector q(blank.n_dofs());
        q[i] = 1.;
        const auto moved = blank.positions(q);
        for (unsigned int n = 0; n < moved.size(); ++n)
          for (unsigned int k = 0; k < 2; ++k)
            if (std::abs(moved[n][k] - start[n][k]) > .5)
              result[i] = {n, k};
      }
      return result;
    }

    /// Turn the state @p q about the origin by @p angle and move it by @p shift.
    inline Vector
    moved_rigidly(const Blank &blank, const Vector &q, const double angle, const Tensor1 &shift = Tensor1())
    {
      const auto role = roles(blank);
      const auto X = blank.positions(Vector(q.size())), x = blank.positions(q);
      const double c = std::cos(angle), s = std::sin(angle);
      Vector result(q.size());
      for (unsigned int i = 0; i < q.size(); ++i)
        if (role[i].node == invalid_index)
          result[i] = q[i] + angle;
        else
        {
          const Point2 &from = x[role[i].node];
          const Tensor1 to({c * from[0] - s * from[1], s * from[0] + c * from[1]});
          result[i] = to[role[i].axis] + shift[role[i].axis] - X[role[i].node][role[i].axis];
        }
      for (const auto dof : blank.fixed_dofs())
        result[dof] = 0.;
      return result;
    }
  } // namespace testing
} // namespace deltaform
