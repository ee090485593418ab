#include "scene_templates.h"

namespace deltaform
{
  namespace
  {
    const char *const sheet_metal = R"(
# Mild steel of the NUMISHEET'93 U-bend: stress = K (e0 + e)^n. Put in the constants of your own metal;
# 'deltaform --list' names the other hardening laws.
subsection Material
  set Model           = elastoplastic
  set Young's modulus = 206e3
  set Poisson's ratio = 0.3
  subsection Hardening
    set Law                  = swift
    set Strength coefficient = 565.32
    set Prestrain            = 0.007117
    set Hardening exponent   = 0.2589
  end
end
)";

    const char *const cup_text = R"(# A round cup with a flat bottom, drawn from a disc. Units mm, N, MPa.
#
#   deltaform {file} --check --svg {stem}.svg     looks at the scene
#   deltaform {file}                             runs it
#   deltaform explain "Tools/holder/Force"       says what an entry means
set Title = Cup
set Units = mm, N, MPa

# The blank's middle line from the axis to its rim; elements as long as the sheet is thick.
subsection Blank
  set Kind      = shell
  set Symmetry  = axisymmetric
  set Points    = 0 0; {blank radius} 0
  set Thickness = {thickness}
  set Elements  = {elements}
end
{material}
subsection Tools
  set Names = punch, die, holder
  subsection punch
    set Shape                = flat punch
    set Radius               = {punch radius}
    set Edge radius          = {punch edge}
    set Side                 = top
    set Position z           = thickness/2
    set Motion               = {depth}*t          # t goes from 0 to 1
    set Friction coefficient = {friction}
  end
  # The gap between punch and die is a quarter wider than the sheet: its rim thickens.
  subsection die
    set Shape                = die
    set Throat radius        = {throat}
    set Profile radius       = {die radius}
    set Side                 = bottom
    set Position z           = -thickness/2
    set Friction coefficient = {friction}
  end
  subsection holder
    set Shape                = plate
    set Inner radius         = {holder inside}
    set Edge radius          = 1
    set Side                 = top
    set Position z           = thickness/2
    set Force                = {holder force}     # N, of the whole circumference
    set Friction coefficient = {friction}
  end
end

subsection Contact
  set Allowed penetration = 1e-3*thickness
end

subsection Steps
  set Stages = draw
  subsection draw
    set End time = 1
  end
end
)";

    const char *const stretch_text = R"(# A clamped disc is stretched over a hemispherical punch. Units mm, N, MPa.
set Title = Stretching over a hemispherical punch
set Units = mm, N, MPa

# From the axis to the draw bead, where the sheet is held.
subsection Blank
  set Kind      = shell
  set Symmetry  = axisymmetric
  set Points    = 0 0; {blank radius} 0
  set Thickness = {thickness}
  set Elements  = {elements}
end
{material}
subsection Tools
  set Names = punch, die
  subsection punch
    set Shape                = hemispherical punch
    set Radius               = {punch radius}
    set Side                 = top
    set Position z           = thickness/2
    set Motion               = {depth}*t
    set Friction coefficient = {friction}
  end
  subsection die
    set Shape                = die
    set Throat radius        = {throat}
    set Profile radius       = {die radius}
    set Side                 = bottom
    set Position z           = -thickness/2
    set Friction coefficient = {friction}
  end
end

subsection Supports
  set Names = bead r, bead z, bead rotation
  subsection bead r
    set Boundary  = end
    set Component = r
  end
  subsection bead z
    set Boundary  = end
    set Component = z
  end
  subsection bead rotation
    set Boundary  = end
    set Component = rotation
  end
end

subsection Contact
  set Allowed penetration = 1e-3*thickness
end

subsection Steps
  set Stages = form
  subsection form
    set End time = 1
  end
end
)";

    const char *const bend_text = R"(# Half of a strip, bent between punch and die, and its springback.
# Units mm, N, MPa. Plane strain: forces are per mm of width.
set Title = Bending and springback
set Units = mm, N, MPa

# From the plane of symmetry to the free end. Springback wants many layers.
subsection Blank
  set Kind      = shell
  set Symmetry  = plane strain
  set Points    = 0 0; {blank length} 0
  set Thickness = {thickness}
  set Elements  = {elements}
  set Layers    = 15
end
{material}
subsection Tools
  set Names = punch, die
  subsection punch
    set Shape                = flat punch
    set Radius               = {punch half width}
    set Edge radius          = {punch edge}
    set Side                 = top
    set Position z           = thickness/2
    set Motion               = {depth}*t
    set Friction coefficient = {friction}
    set Stages               = bend               # gone in the second stage
  end
  subsection die
    set Shape                = die
    set Throat radius        = {throat}
    set Profile radius       = {die radius}
    set Side                 = bottom
    set Position z           = -thickness/2
    set Friction coefficient = {friction}
    set Stages               = bend
  end
end

# Symmetry; and in the stage without tools something has to hold the strip.
subsection Supports
  set Names = symmetry r, symmetry rotation, floor
  subsection symmetry r
    set Boundary  = start
    set Component = r
  end
  subsection symmetry rotation
    set Boundary  = start
    set Component = rotation
  end
  subsection floor
    set Boundary  = start
    set Component = z
    set Hold      = true                          # where it is when the stage begins
    set Stages    = release
  end
end

subsection Contact
  set Allowed penetration = 1e-3*thickness
end

subsection Steps
  set Stages = bend, release
  subsection bend
    set End time = 1
  end
  subsection release
    set End time = 2
  end
end

# What springback leaves: the angle between the middle and the free end, in summary.json (measures).
subsection Output
  subsection Measures
    set Names = bend
    subsection bend
      set Kind       = angle
      set First leg  = 0 {middle}                 # from where to where, along the undeformed strip
      set Second leg = {tip} {blank length}
    end
  end
end
)";

    const char *const upset_text = R"(# A cylinder is upset between two platens, of which its upper half is computed.
# Units mm, N, MPa.
set Title = Upsetting of a cylinder
set Units = mm, N, MPa

# A solid: the middle line of the upper half, and its height as the thickness.
subsection Blank
  set Kind                       = solid
  set Symmetry                   = axisymmetric
  set Points                     = 0 {middle}; {radius} {middle}
  set Thickness                  = {half height}
  set Elements                   = {elements}
  set Elements through thickness = {elements through}
  set Contact top                = top, end       # the side may fold onto the platen
end

# A bar of steel as in the benchmark of Lippmann (1979), with linear hardening.
subsection Material
  set Model           = elastoplastic
  set Young's modulus = 200e3
  set Poisson's ratio = 0.3
  subsection Hardening
    set Law                 = linear
    set Initial flow stress = 700
    set Hardening modulus   = 300
  end
end

subsection Tools
  set Names = platen
  subsection platen
    set Shape                = plate
    set Side                 = top
    set Position z           = {half height}
    set Motion               = {stroke}/2*t
    set Friction coefficient = {friction}
  end
end

subsection Supports
  set Names = middle
  subsection middle
    set Boundary  = bottom
    set Component = z
  end
end

subsection Contact
  set Allowed penetration = 1e-4*edge
end

subsection Steps
  set Stages = press
  subsection press
    set End time = 1
  end
end
)";

    std::string with_sheet_metal(const std::string &text)
    {
      const std::string gap = "{material}";
      const auto at = text.find(gap);
      return text.substr(0, at) + sheet_metal + text.substr(at + gap.size());
    }
  } // namespace


  const std::vector<SceneTemplate> &scene_templates()
  {
    static const std::vector<SceneTemplate> all = {
      {"cup",
       "a round cup with a flat bottom, drawn with a blank holder",
       {{"blank radius", "50", "of the disc"},
        {"thickness", "1", "of the sheet"},
        {"punch radius", "27", "of the punch's wall"},
        {"punch edge", "6", "radius between its face and wall"},
        {"die radius", "6", "of the die's profile"},
        {"depth", "20", "travel of the punch"},
        {"holder force", "10000", "N"},
        {"friction", "0.1", "coefficient, of all tools"}},
       {{"elements", "rint(blank_radius/thickness)"},
        {"throat", "punch_radius + 1.25*thickness"},
        {"holder inside", "punch_radius + 1.25*thickness + die_radius"}},
       with_sheet_metal(cup_text)},
      {"stretch",
       "a clamped disc over a hemispherical punch",
       {{"blank radius", "59", "to where the sheet is held"},
        {"thickness", "1", "of the sheet"},
        {"punch radius", "50", "of the hemisphere"},
        {"die radius", "6", "of the die's profile"},
        {"depth", "25", "travel of the punch"},
        {"friction", "0.1", "coefficient, of both tools"}},
       {{"elements", "rint(blank_radius/thickness)"}, {"throat", "punch_radius + 2*thickness"}},
       with_sheet_metal(stretch_text)},
      {"bend",
       "a strip between punch and die, and its springback",
       {{"blank length", "60", "of the half"},
        {"thickness", "1", "of the sheet"},
        {"punch half width", "20", "half of the punch"},
        {"punch edge", "5", "radius between its face and wall"},
        {"die radius", "5", "of the die's profile"},
        {"depth", "20", "travel of the punch"},
        {"friction", "0.1", "coefficient, of both tools"}},
       {{"elements", "rint(blank_length/thickness)"},
        {"throat", "punch_half_width + 1.1*thickness"},
        {"middle", "max(punch_half_width - punch_edge, blank_length/10)"},
        {"tip", "0.9*blank_length"}},
       with_sheet_metal(bend_text)},
      {"upset",
       "a cylinder between platens",
       {{"radius", "10", "of the cylinder"},
        {"height", "30", "of the cylinder"},
        {"stroke", "12", "by which it gets shorter"},
        {"friction", "0.1", "coefficient, of the platens"}},
       {{"half height", "height/2"},
        {"middle", "height/4"},
        {"elements", "10"},
        {"elements through", "rint(max(5*height/radius, 4))"}},
       upset_text}};
    return all;
  }
} // namespace deltaform
