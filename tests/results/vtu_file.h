#pragma once

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// Reads a .vtu file of inline arrays without compression as VTK does, and only such a file.
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
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(path, tree);
    const auto &file = tree.get_child("VTKFile");
    BOOST_TEST(file.get<std::string>("<xmlattr>.type") == "UnstructuredGrid");
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
  }

  unsigned int n_points, n_cells;
  Array points;
  std::map<std::string, Array> cells; ///< connectivity, offsets, types
  std::map<std::string, Array> fields, cell_fields;

private:
  static std::string decode(const std::string &text)
  {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    std::uint32_t bits = 0;
    unsigned int n_bits = 0;
    for (const char c : text)
    {
      const auto digit = digits.find(c);
      if (digit == std::string::npos) // padding, white space
        continue;
      bits = (bits << 6) | static_cast<std::uint32_t>(digit);
      n_bits += 6;
      if (n_bits >= 8)
        result += static_cast<char>((bits >> (n_bits -= 8)) & 0xff);
    }
    return result;
  }

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

  static Array array(const boost::property_tree::ptree &element)
  {
    BOOST_TEST(element.get<std::string>("<xmlattr>.format") == "binary");
    std::string text = element.data();
    text.erase(0, text.find_first_not_of(" \n"));
    if (text.size() < 8)
      throw std::runtime_error("an array of the file is empty");
    // The number of bytes, then the bytes, in one piece of base64.
    std::string bytes = decode(text);
    std::uint32_t size;
    std::memcpy(&size, bytes.data(), sizeof size);
    bytes.erase(0, sizeof size);
    BOOST_TEST(bytes.size() == size);

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
};
