#pragma once

#include "../conformance.h"

#include <deltaform/materials/hardening.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/parameters/section.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <random>
#include <sstream>

namespace deltaform
{
  namespace testing
  {
    /// Any registered hardening law with the parameters of its documentation.
    inline std::unique_ptr<Hardening> make_hardening(const std::string &law)
    {
      ParameterTree tree = ParameterTree::documentation();
      Section section = tree.root().sub("Hardening");
      return Registry<Hardening>::make(law, section);
    }

    /// Any registered hardening law with given parameters, "entry=value".
    inline std::unique_ptr<Hardening> make_hardening(const std::string &law, const std::vector<std::string> &entries)
    {
      ParameterTree tree = ParameterTree::parse("", "test", entries);
      Section section = tree.root();
      auto hardening = Registry<Hardening>::make(law, section);
      tree.check_unused();
      return hardening;
    }

    /// Registered hardening laws whose flow stress depends on the strain alone.
    inline std::vector<std::string> laws_of_strain()
    {
      std::vector<std::string> result;
      for (const auto &name : Registry<Hardening>::names())
        if (!make_hardening(name)->own_rate_factor(0.))
          result.push_back(name);
      return result;
    }

    /**
     * Any registered material with the parameters of its documentation, with any hardening law likewise (which
     * materials without hardening ignore), changed by @p overrides "Material/entry=value".
     */
    inline std::unique_ptr<Material>
    make_material(const std::string &name, const std::string &law, const std::vector<std::string> &overrides = {})
    {
      std::vector<std::string> entries = documented_entries(
        [&](ParameterTree &tree) {
          Section section = tree.root().sub("Material");
          Registry<Material>::make(name, section);
        });
      for (const auto &entry : documented_entries(
             [&](ParameterTree &tree) {
               Section section = tree.root().sub("Material").sub("Hardening");
               Registry<Hardening>::choose(section, "Law", law, "");
             }))
        entries.push_back(entry);
      entries.insert(entries.end(), overrides.begin(), overrides.end());
      ParameterTree tree = ParameterTree::parse("", "test", entries);
      Section section = tree.root().sub("Material");
      return Registry<Material>::make(name, section);
    }

    /// One point of a material with its history.
    struct MaterialPoint
    {
      /// @param two_steps is the flow of the last increment carried on?
      explicit MaterialPoint(const Material &law, const bool two_steps = false)
        : material(law), committed(law.history_size(), 0.), trial(law.history_size(), 0.),
          predictor(two_steps ? law.history_size() : 0, 0.)
      {
      }

      /// Stress at @p e; with stress_given e[2] is overwritten.
      Mandel update(Mandel &e, const ThirdDirection third, const double third_stress = 0., double *C = nullptr)
      {
        Mandel stress{};
        MaterialBatch batch;
        batch.n_points = 1;
        batch.third_direction = third;
        batch.strain = &e;
        batch.third_stress = &third_stress;
        batch.duration = duration;
        batch.duration_share = predictor.empty() ? 1. : 2. / 3.; // increments of the same length
        batch.committed = committed.data();
        batch.committed_stress = &committed_stress;
        batch.predictor = predictor.empty() ? nullptr : predictor.data();
        batch.trial = trial.data();
        batch.stress = &stress;
        batch.tangent = C;
        status = material.update(batch);
        trial_stress = stress;
        return stress;
      }

      Mandel solid(const Mandel &e, double *C = nullptr)
      {
        Mandel copy = e;
        return update(copy, ThirdDirection::strain_given, 0., C);
      }

      void commit()
      {
        for (std::size_t i = 0; i < predictor.size(); ++i)
          predictor[i] = (trial[i] - committed[i]) / 3.; // increments of the same length
        committed.swap(trial);
        committed_stress = trial_stress;
      }

      double equivalent_plastic_strain() const
      {
        return material.equivalent_plastic_strain(trial.data());
      }

      const Material &material;
      std::vector<double> committed, trial, predictor;
      Mandel committed_stress{}, trial_stress{};
      double duration = .5;
      Status status;
    };

    /// Strain at which the documented materials are well into yielding.
    inline Mandel random_strain(std::mt19937 &generator, const double size)
    {
      std::uniform_real_distribution<double> uniform(-size, size);
      Mandel e;
      for (auto &component : e)
        component = uniform(generator);
      return e;
    }

    inline double norm(const Mandel &a)
    {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]);
    }

    inline Mandel difference(const Mandel &a, const Mandel &b)
    {
      return {{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}};
    }

    inline double scalar_product(const Mandel &a, const Mandel &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    }

    /// The Mises stress, from the definition by principal differences.
    inline double mises(const Mandel &t)
    {
      const double d1 = t[0] - t[1], d2 = t[1] - t[2], d3 = t[2] - t[0];
      return std::sqrt((d1 * d1 + d2 * d2 + d3 * d3) / 2. + 1.5 * t[3] * t[3]);
    }
  } // namespace testing
} // namespace deltaform
