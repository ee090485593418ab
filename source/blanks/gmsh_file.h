#pragma once

#include <deltaform/assembly/types.h>

#include <deal.II/grid/tria_description.h>

#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace deltaform
{
  class GmshWords;

  /**
   * A plane mesh of quadrilaterals as Gmsh writes it: ASCII, formats 2.0 to 2.2, 4.0 and 4.1 (Gmsh reference manual,
   * "File formats"). Nothing in the file is trusted: every count is held against what the file can hold before memory
   * is taken for it, every number of a node is looked up, and the cells must be a mesh: each has an area, each edge
   * belongs to one cell or two, lines of the boundary are edges of one cell.
   */
  class GmshFile
  {
  public:
    /// @throws std::invalid_argument with a sentence that names the line, where it is no such mesh
    explicit GmshFile(const std::string &content);

    std::vector<Point2> vertices; ///< those that cells use
    std::vector<dealii::CellData<2>> cells; ///< in the order of corners that deal.II expects
    dealii::SubCellData boundary; ///< lines with the number of their physical curve
    std::map<unsigned int, std::string> names; ///< of physical curves

  private:
    using Number = long long;

    void read_format(GmshWords &words);
    void read_names(GmshWords &words);
    void read_entities(GmshWords &words);
    void read_nodes(GmshWords &words);
    void read_elements(GmshWords &words);
    void read_element(GmshWords &words, Number type, unsigned int physical);

    /// The physical group of an entity of the geometry (format 4); 0: none.
    unsigned int group_of(Number dimension, Number tag) const;

    /// Which vertex is the node of this number?
    unsigned int vertex(GmshWords &words, Number tag) const;

    /// Turn cells that are clockwise. Are these the cells of a mesh?
    void check_cells();

    /// Of every edge of two cells or one; the lines of the boundary have one.
    void check_edges();

    unsigned int format_ = 0; ///< 20 to 22, 40, 41; 0: not known yet
    bool has_nodes_ = false, has_elements_ = false;
    std::unordered_map<Number, unsigned int> numbers_; ///< of nodes, to vertices
    std::array<std::map<Number, unsigned int>, 4> groups_; ///< of entities, by dimension
  };
} // namespace deltaform
