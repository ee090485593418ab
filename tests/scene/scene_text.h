#pragma once
// Small scenes for the tests of what looks at a whole scene.
#include <deltaform/scene/scene.h>

#include <memory>
#include <string>

namespace deltaform
{
  namespace testing
  {
    /// A scene and the tree that it is read from.
    struct ReadScene
    {
      explicit ReadScene(const std::string &text)
        : tree(ParameterTree::parse(text, "test.prm")), scene(std::make_unique<Scene>(tree))
      {
      }

      ParameterTree tree;
      std::unique_ptr<Scene> scene;
    };

    /// An elastic strip in plane strain from x = -10 to 10, 1 thick, held at its ends, and its tools: entries of
    /// section Tools. Two stages, 'one' until t = 1 and 'two' until t = 2.
    inline std::string strip(const std::string &tools, const std::string &blank = "set Elements = 20\n")
    {
      return "subsection Blank\n set Symmetry = plane strain\n set Points = -10 0; 10 0\n set Thickness = 1\n" + blank +
             "end\nsubsection Material\n set Model = linear elastic\n set Young's modulus = 1e3\n"
             " set Poisson's ratio = .3\nend\nsubsection Tools\n" +
             tools +
             "end\nsubsection Supports\n set Names = left, right\n"
             " subsection left\n  set Boundary = start\n  set Component = r\n  set Value = -1e-3*t\n end\n"
             " subsection right\n  set Boundary = end\n  set Component = r\n end\nend\n"
             "subsection Steps\n set Stages = one, two\n subsection one\n  set End time = 1\n end\n"
             " subsection two\n  set End time = 2\n end\nend\n";
    }

    /// Subsection of a tool.
    inline std::string tool(const std::string &name, const std::string &entries)
    {
      return " subsection " + name + "\n" + entries + " end\n";
    }
  } // namespace testing
} // namespace deltaform
