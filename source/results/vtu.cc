#include <deltaform/base/atomic_file.h>
#include <deltaform/results/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <array>
#include <ostream>
#include <tuple>

namespace deltaform
{
  namespace
  {
    using Interpretation = dealii::DataComponentInterpretation::DataComponentInterpretation;

    /// The label of a field in ParaView. The file is XML and deal.II does not escape.
    std::string label(const DrawnField &field, const Units &units)
    {
      const std::string unit = units.of(field.unit);
      std::string result;
      for (const char c : field.name + " [" + (unit == "1" ? "-" : unit) + "]")
        if (c == '<')
          result += "&lt;";
        else if (c == '&')
          result += "&amp;";
        else if (c == '"')
          result += "&quot;";
        else
          result += c;
      return result;
    }

    /// A drawing of lines (dim = 1) or quadrilaterals (dim = 2) as deal.II's patches, one per cell.
    template <int dim>
    std::vector<dealii::DataOutBase::Patch<dim, 2>> patches_of(const Drawing &drawing, const unsigned int n_components)
    {
      constexpr unsigned int n_vertices = dim == 1 ? 2 : 4;
      // deal.II numbers the vertices of a quadrilateral lexicographically, a drawing goes round.
      constexpr std::array<unsigned int, 4> order{{0, 1, 3, 2}};

      const auto n_cells = static_cast<unsigned int>(drawing.cells.size() / n_vertices);
      std::vector<dealii::DataOutBase::Patch<dim, 2>> patches(n_cells);
      for (unsigned int c = 0; c < n_cells; ++c)
      {
        auto &patch          = patches[c];
        patch.patch_index    = c;
        patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>(); // else cells without type are written
        patch.data.reinit(n_components, n_vertices);
        for (unsigned int v = 0; v < n_vertices; ++v)
        {
          const unsigned int point = drawing.cells[n_vertices * c + order[v]];
          patch.vertices[v]        = drawing.points[point];
          unsigned int component   = 0;
          for (const auto &field : drawing.fields)
          {
            const std::size_t first = std::size_t(field.per_point ? point : c) * field.n_components;
            for (unsigned int k = 0; k < field.n_components; ++k)
              patch.data(component++, v) = static_cast<float>(field.values[first + k]);
          }
        }
      }
      return patches;
    }

    template <int dim>
    void write(std::ostream &out, const Drawing &drawing, const Units &units)
    {
      std::vector<std::string> names;
      std::vector<std::tuple<unsigned int, unsigned int, std::string, Interpretation>> vectors;
      for (const auto &field : drawing.fields)
      {
        Assert(field.values.size() ==
                 field.n_components * (field.per_point ? drawing.points.size() : drawing.cells.size() / (2 * dim)),
               dealii::ExcMessage("Field '" + field.name + "' does not fit the drawing."));
        const auto first       = static_cast<unsigned int>(names.size());
        const std::string name = label(field, units);
        names.insert(names.end(), field.n_components, name);
        if (field.n_components > 1)
          vectors.emplace_back(first,
                               first + field.n_components - 1,
                               name,
                               dealii::DataComponentInterpretation::component_is_part_of_vector);
      }
      dealii::DataOutBase::VtkFlags flags;
      // Even the fastest compression makes writing take 1.5 to 3 times as long; files are a third as large with it.
      flags.compression_level   = dealii::DataOutBase::VtkFlags::no_compression;
      flags.print_date_and_time = false;
      dealii::DataOutBase::write_vtu(
        patches_of<dim>(drawing, static_cast<unsigned int>(names.size())), names, vectors, flags, out);
    }
  } // namespace

  void write_vtu(const std::string &path, const Drawing &drawing, const Units &units)
  {
    write_file_atomically(path,
                          [&](std::ostream &out)
                          {
                            if (drawing.points_per_cell == 2)
                              write<1>(out, drawing, units);
                            else
                              write<2>(out, drawing, units);
                          });
  }
} // namespace deltaform
