#include <deltaform/base/atomic_file.h>
#include <deltaform/results/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <ostream>

namespace deltaform
{
  namespace
  {
    template <int dim>
    void
    write(std::ostream &out, const Drawing &drawing, const Units &units)
    {
      constexpr unsigned int n_vertices = dim == 1 ? 2 : 4;
      // deal.II numbers the vertices of a quadrilateral lexicographically, a drawing goes round.
      constexpr std::array<unsigned int, 4> order{{0, 1, 3, 2}};

      std::vector<std::string> names;
      std::vector<std::tuple<unsigned int, unsigned int, std::string, dealii::DataComponentInterpretation::DataComponentInterpretation>>
                   vectors;
      unsigned int n_components = 0;
      for (const auto &field : drawing.fields)
        {
          const std::string name = field.name + " [" + units.of(field.unit) + "]";
          if (field.n_components > 1)
            vectors.emplace_back(n_components,
                                 n_components + field.n_components - 1,
                                 name,
                                 dealii::DataComponentInterpretation::component_is_part_of_vector);
          names.insert(names.end(), field.n_components, name);
          n_components += field.n_components;
        }

      const unsigned int                                n_cells = drawing.cells.size() / n_vertices;
      std::vector<dealii::DataOutBase::Patch<dim, 2>> patches(n_cells);
      for (unsigned int c = 0; c < n_cells; ++c)
        {
          auto &patch       = patches[c];
          patch.patch_index = c;
          patch.data.reinit(n_components, n_vertices);
          for (unsigned int v = 0; v < n_vertices; ++v)
            {
              const unsigned int point = drawing.cells[n_vertices * c + order[v]];
              patch.vertices[v]        = drawing.points[point];
              unsigned int component   = 0;
              for (const auto &field : drawing.fields)
                for (unsigned int k = 0; k < field.n_components; ++k)
                  patch.data(component++, v) = static_cast<float>(
                    field.values[(field.per_point ? point : c) * field.n_components + k]);
            }
        }
      dealii::DataOutBase::VtkFlags flags;
      flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
      flags.print_date_and_time = false;
      dealii::DataOutBase::write_vtu(patches, names, vectors, flags, out);
    }
  } // namespace



  void
  write_vtu(const std::string &path, const Drawing &drawing, const Units &units)
  {
    write_file_atomically(path, [&](std::ostream &out) {
      if (drawing.points_per_cell == 2)
        write<1>(out, drawing, units);
      else
        write<2>(out, drawing, units);
    });
  }



  PictureSeries::PictureSeries(std::string path)
    : path_(std::move(path))
  {}



  void
  PictureSeries::add(const double time, const std::vector<std::string> &parts)
  {
    pictures_.emplace_back(time, parts);
    write_file_atomically(path_, [&](std::ostream &out) {
      out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
      for (const auto &[when, files] : pictures_)
        for (unsigned int part = 0; part < files.size(); ++part)
          out << "    <DataSet timestep=\"" << when << "\" part=\"" << part << "\" file=\"" << files[part] << "\"/>\n";
      out << "  </Collection>\n</VTKFile>\n";
    });
  }
} // namespace deltaform
