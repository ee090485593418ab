#include "xml.h"

#include <deltaform/io/atomic_file.h>
#include <deltaform/io/vtu.h>

#include <cstdint>
#include <cstring>
#include <ostream>

// The format: https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html, arrays appended as raw bytes,
// each after its size in bytes (UInt64). Written here and not by deal.II's DataOutBase, which has them in base64: a
// third more bytes and most of the time.

namespace deltaform
{
  namespace
  {
    /// The label of a field in ParaView, as XML.
    std::string label(const DrawnField &field, const Units &units)
    {
      const std::string unit = units.of(field.unit);
      return xml_attribute(field.name + " [" + (unit == "1" ? "-" : unit) + "]");
    }

    /// The third axis of the drawing is the hoop direction (plane strain: the normal of the plane).
    constexpr const char *tensor_components =
      R"( ComponentName0="rr" ComponentName1="zz" ComponentName2="hoop" ComponentName3="rz")"
      R"( ComponentName4="z hoop" ComponentName5="r hoop")";

    /// The arrays of a file, whose bytes follow when its XML is closed.
    class Arrays
    {
    public:
      /// Declare an array in the XML @p out, and keep its bytes.
      template <typename T>
      void add(std::ostream &out, const std::string &attributes, const std::vector<T> &values)
      {
        out << "<DataArray " << attributes << " format=\"appended\" offset=\"" << bytes_.size() << "\"/>\n";
        const std::uint64_t n = values.size() * sizeof(T);
        bytes_.append(reinterpret_cast<const char *>(&n), sizeof n);
        bytes_.append(reinterpret_cast<const char *>(values.data()), n);
      }

      const std::string &bytes() const
      {
        return bytes_;
      }

    private:
      std::string bytes_;
    };

    /// Vectors have three components and symmetric tensors six: ParaView takes them for such.
    void write_field(std::ostream &out, Arrays &arrays, const DrawnField &field, const Units &units)
    {
      const unsigned int n = field.n_components, n_written = n == 1 ? 1 : (n == 2 ? 3 : 6);
      Assert(n == 1 || n == 2 || n == 4,
             dealii::ExcMessage("Field '" + field.name + "' is no scalar, vector, tensor."));
      std::vector<float> values(field.values.size() / n * n_written, 0.f);
      for (std::size_t i = 0; i < field.values.size(); ++i)
        values[i / n * n_written + i % n] = static_cast<float>(field.values[i]);
      arrays.add(out,
                 "type=\"Float32\" Name=\"" + label(field, units) + "\" NumberOfComponents=\"" +
                   std::to_string(n_written) + "\"" + (n == 4 ? tensor_components : ""),
                 values);
    }

    void write(std::ostream &out, const Drawing &drawing, const Units &units)
    {
      const unsigned int n_vertices = drawing.points_per_cell;
      const std::size_t n_points = drawing.points.size(), n_cells = drawing.cells.size() / n_vertices;
      const std::uint16_t one = 1;
      unsigned char first = 0;
      std::memcpy(&first, &one, 1);
      out << "<?xml version=\"1.0\"?>\n"
          << R"(<VTKFile type="UnstructuredGrid" version="1.0" header_type="UInt64" byte_order=")"
          << (first == 1 ? "LittleEndian" : "BigEndian") << "\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
          << n_points << "\" NumberOfCells=\"" << n_cells << "\">\n<Points>\n";
      Arrays arrays;
      std::vector<float> values;
      values.reserve(3 * n_points);
      for (const Point2 &point : drawing.points)
        values.insert(values.end(), {static_cast<float>(point[0]), static_cast<float>(point[1]), 0.f});
      arrays.add(out, R"(type="Float32" NumberOfComponents="3")", values);

      const std::vector<std::int32_t> connectivity(drawing.cells.begin(), drawing.cells.end());
      std::vector<std::int32_t> offsets(n_cells);
      for (std::size_t c = 0; c < n_cells; ++c)
        offsets[c] = static_cast<std::int32_t>(n_vertices * (c + 1));
      constexpr std::uint8_t line = 3, quadrilateral = 9; // VTK_LINE, VTK_QUAD
      const std::vector<std::uint8_t> types(n_cells, n_vertices == 2 ? line : quadrilateral);
      out << "</Points>\n<Cells>\n";
      arrays.add(out, R"(type="Int32" Name="connectivity")", connectivity);
      arrays.add(out, R"(type="Int32" Name="offsets")", offsets);
      arrays.add(out, R"(type="UInt8" Name="types")", types);

      out << "</Cells>\n";
      for (const bool per_point : {true, false})
      {
        const char *const where = per_point ? "PointData" : "CellData";
        out << '<' << where << ">\n";
        for (const auto &field : drawing.fields)
          if (field.per_point == per_point)
          {
            Assert(field.values.size() == field.n_components * (per_point ? n_points : n_cells),
                   dealii::ExcMessage("Field '" + field.name + "' does not fit the drawing."));
            write_field(out, arrays, field, units);
          }
        out << "</" << where << ">\n";
      }
      out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" << arrays.bytes()
          << "\n</AppendedData>\n</VTKFile>\n";
    }
  } // namespace

  void write_vtu(const std::string &path, const Drawing &drawing, const Units &units)
  {
    write_file_atomically(path, [&](std::ostream &out) { write(out, drawing, units); });
  }
} // namespace deltaform
