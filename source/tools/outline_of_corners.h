#pragma once
// What the shapes have in common that are drawn in the scene's frame; private to the tools.
#include "outline_path.h"

#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

#include <string>

namespace deltaform
{
  /// A shape of corners with fillets in the scene's frame: moved by the tool's position, but never mirrored.
  class OutlineOfCorners : public Shape
  {
  public:
    void set_plane_strain() override;

    bool in_scene_frame() const override
    {
      return true;
    }

  protected:
    /// Reads the entry `Across the axis`.
    void read_ends(Section &section);

    /// @throws std::invalid_argument if lines and fillets do not fit
    void set_corners(OutlineCorners corners);

  private:
    void build_corners(bool across);

    OutlineCorners corners_;
    std::string across_;
  };
} // namespace deltaform
