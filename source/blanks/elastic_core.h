#pragma once

#include "layer_motion.h"
#include "virgin_metal.h"

#include <array>
#include <type_traits>
#include <vector>

namespace deltaform
{
  /**
   * The part of the thickness that has never flowed, at every quadrature point of a shell, and what the layers do not
   * see of the kinks of the stress at its two ends. Beyond an end c the stress has the jump J of its slope:
   *
   *     stress = smooth part + K,   K(z) = J (z - c) outside, 0 inside the core,   K = about -C e_p.
   *
   * The layers integrate the smooth part, K is integrated exactly. Ends and jumps are those of the accepted state, as
   * thickness and third stress are: K does not change within an increment. Histories stay where they are. Derivation:
   * doc/theory/shell.md.
   */
  class ElasticCore
  {
  public:
    /// @param follows: else there is nothing to correct
    ElasticCore(const ShellPoints &points, MaterialPoints &material, bool follows);

    /// The mesh is another one: all of the metal is virgin.
    void set_up();

    bool follows() const
    {
      return follows_;
    }

    /// What corrects the sum over the layers: a place, its weight, and the stress there.
    struct Correction
    {
      double position, weight; ///< both initial (length)
      Mandel stress;
    };

    /// Those at the layers are negative weights.
    void corrections(unsigned int place, std::vector<Correction> &result) const;

    /// Work per area of the mid-surface of the corrections; @p first, @p last: changes of the strains at the first and
    /// the last layer
    double work(unsigned int place, const Mandel &first, const Mandel &last) const;

    /// The increment is accepted, before the layers accept it: the ends move inwards to where the trial state begins to
    /// flow. Where layers outside the core flow back, its kink fades into another one, which is left to the layers.
    void commit(unsigned int place, const LayerMotion &motion, double third_stress);

    /// Every array of the state with its name.
    template <typename Core, typename Action>
    static void each_array(Core &core, const Action &action)
    {
      if (core.follows_)
        action("elastic core", core.ends_);
    }

  private:
    /// One end of the core.
    struct End
    {
      double position = 0.; ///< c, initial (length)
      double jump[2] = {0., 0.}; ///< J, both stresses (stress/length)
      double share = 1.; ///< of K that is left
      double exists = 1.; ///< 0 if there is no core any more
    };
    static_assert(std::is_trivially_copyable_v<End>);
    using Ends = std::array<End, 2>; ///< bottom, top

    /// Move an end inwards to where flow ends, at most to @p limit. @return did flow reach it?
    bool move(unsigned int side, const LayerMotion &motion, double third_stress, double limit, End &end) const;

    /// Slope of K of an end that moved.
    void fit(unsigned int place, unsigned int side, const LayerMotion &motion, double third_stress, End &end) const;

    /// What corrects K of an end: places and weights.
    template <typename Visit>
    void visit(unsigned int side, const End &end, const Visit &at) const;

    /// Share of the layers outside an end that do not flow back in this increment.
    double not_reversed(unsigned int place, unsigned int side, const End &end) const;

    const ShellPoints &points_;
    MaterialPoints &material_;
    bool follows_;
    std::vector<Ends> ends_; ///< of the accepted state
    VirginMetal virgin_;
    VirginMetal::Moduli elastic_{}; ///< C
    double enough_ = 0.; ///< equivalent plastic strain that counts as none
  };
} // namespace deltaform
