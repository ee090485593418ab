#pragma once

#include <deltaform/loads/load.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  /// A pressure on a face of the blank: f = -int p N da, on the current area along the current normal (it follows the
  /// surface) or on the initial ones (it is dead).
  template <bool follows>
  class FacePressure : public Load
  {
  public:
    FacePressure(Section &section, const Blank &blank)
      : Load(section,
             blank,
             {"stress",
              "Pressure as a function of time t, positive if it pushes into the blank (bottom: upwards on a flat "
              "blank).",
              "volume"}),
        boundary_(blank.boundary()), face_(section.choice("Face",
                                                          boundary_.faces().front(),
                                                          boundary_.faces(),
                                                          "What the pressure acts on (shell: the bottom)."))
    {
    }

    void add(const Vector &q, const double value, AssemblyTarget &target) const override
    {
      boundary_.assemble_pressure(q, face_, value, follows, target);
    }

    std::string pressed_face() const override
    {
      return face_;
    }

  private:
    const Boundary &boundary_;
    std::string face_;
  };
} // namespace deltaform
