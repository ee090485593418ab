#pragma once

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Reads a .vtu file with arrays that are appended as raw bytes without compression, as VTK does, and only such a file.
class VtuFile
{
public:
  /// An array of the file; all types of numbers as double.
  struct Array
  {
    unsigned int n_components = 1;
    std::vector<std::string> component_names;
    std::vector<double> values;
  };

  explicit VtuFile(const std::string &path)
  {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    // The bytes are no XML: they go from the first underscore to the closing tag.
    const std::string opening = "<AppendedData encoding=\"raw\">", closing = "\n</AppendedData>";
    std::string text = content.str();
    const auto first = text.find('_', text.find(opening)) + 1, last = text.rfind(closing);
    if (text.find(opening) == std::string::npos || last == std::string::npos || last < first)
      throw std::runtime_error("the file has no appended bytes");
    bytes_ = text.substr(first, last - first);
    std::istringstream xml(text.erase(first, last - first));
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(xml, tree);
    const auto &file = tree.get_child("VTKFile");
    BOOST_TEST(file.get<std::string>("<xmlattr>.type") == "UnstructuredGrid");
    BOOST_TEST(file.get<std::string>("<xmlattr>.header_type") == "UInt64");
    BOOST_TEST(!file.get_optional<std::string>("<xmlattr>.compressor"));
    const auto &piece = file.get_child("UnstructuredGrid.Piece");
    n_points = piece.get<unsigned int>("<xmlattr>.NumberOfPoints");
    n_cells = piece.get<unsigned int>("<xmlattr>.NumberOfCells");
    points = array(piece.get_child("Points.DataArray"));
    for (const auto &[name, element] : piece.get_child("Cells"))
      if (name == "DataArray")
        cells[element.get<std::string>("<xmlattr>.Name")] = array(element);
    for (const auto &[name, element] : piece.get_child("PointData"))
      if (name == "DataArray")
        fields[element.get<std::string>("<xmlattr>.Name")] = array(element);
    for (const auto &[name, element] : piece.get_child("CellData"))
      if (name == "DataArray")
        cell_fields[element.get<std::string>("<xmlattr>.Name")] = array(element);
    BOOST_TEST(end_ == bytes_.size());
  }

  unsigned int n_points, n_cells;
  Array points;
  std::map<std::string, Array> cells; ///< connectivity, offsets, types
  std::map<std::string, Array> fields, cell_fields;

private:
  template <typename T>
  static std::vector<double> numbers(const std::string &bytes)
  {
    std::vector<double> result;
    for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T))
    {
      T value;
      std::memcpy(&value, bytes.data() + i, sizeof(T));
      result.push_back(static_cast<double>(value));
    }
    return result;
  }

  Array array(const boost::property_tree::ptree &element)
  {
    BOOST_TEST(element.get<std::string>("<xmlattr>.format") == "appended");
    // The number of bytes, then the bytes; arrays follow each other without a gap.
    const auto offset = element.get<std::size_t>("<xmlattr>.offset");
    BOOST_TEST(offset == end_);
    std::uint64_t size = 0;
    if (offset + sizeof size > bytes_.size())
      throw std::runtime_error("an array begins behind the end of the file");
    std::memcpy(&size, bytes_.data() + offset, sizeof size);
    end_ = offset + sizeof size + size;
    if (end_ > bytes_.size())
      throw std::runtime_error("an array goes beyond the end of the file");
    const std::string bytes = bytes_.substr(offset + sizeof size, size);

    Array result;
    result.n_components = element.get<unsigned int>("<xmlattr>.NumberOfComponents", 1);
    for (unsigned int k = 0; k < result.n_components; ++k)
      if (const auto name = element.get_optional<std::string>("<xmlattr>.ComponentName" + std::to_string(k)))
        result.component_names.push_back(*name);
    const std::string type = element.get<std::string>("<xmlattr>.type");
    if (type == "Float32")
      result.values = numbers<float>(bytes);
    else if (type == "Int32")
      result.values = numbers<std::int32_t>(bytes);
    else if (type == "UInt8")
      result.values = numbers<std::uint8_t>(bytes);
    else
      throw std::runtime_error("unknown type " + type);
    return result;
  }

  std::string bytes_; ///< of all arrays
  std::size_t end_ = 0; ///< of the array that was read last
};
