#pragma once
// The templates of new scenes; private to the application.
#include <string>
#include <vector>

namespace deltaform
{
  /// A scene with gaps.
  struct SceneTemplate
  {
    /// What the user may choose; lengths in mm.
    struct Size
    {
      std::string name, value, meaning;
    };

    /// What follows from the sizes, by an expression in their names (underscores in place of blanks).
    struct Derived
    {
      std::string name, expression;
    };

    std::string name, sentence;
    std::vector<Size> sizes;
    std::vector<Derived> derived;
    std::string text; ///< "{name}" stands for a size or what is derived
  };

  const std::vector<SceneTemplate> &scene_templates();
} // namespace deltaform
