#include "xml.h"

#include <deltaform/io/atomic_file.h>
#include <deltaform/io/picture_series.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <filesystem>
#include <ostream>

namespace deltaform
{
  PictureSeries::PictureSeries(std::string path)
    : path_(std::move(path))
  {
  }

  void PictureSeries::resume(const double time)
  {
    pictures_.clear();
    std::error_code code;
    if (!std::filesystem::exists(path_, code))
      return;
    try
    {
      boost::property_tree::ptree tree;
      boost::property_tree::read_xml(path_, tree);
      for (const auto &[name, element] : tree.get_child("VTKFile.Collection"))
      {
        if (name != "DataSet")
          continue;
        const double when = element.get<double>("<xmlattr>.timestep");
        if (when > time)
          continue;
        if (element.get<unsigned int>("<xmlattr>.part") == 0)
          pictures_.push_back({when, {}});
        if (!pictures_.empty())
          pictures_.back().parts.push_back(
            {element.get<std::string>("<xmlattr>.file"), element.get<std::string>("<xmlattr>.name", "")});
      }
    }
    catch (const boost::property_tree::ptree_error &error)
    {
      throw SceneError("Cannot resume the series of pictures '" + path_ + "': " + error.what() + ".");
    }
  }

  void PictureSeries::add(const double time, const std::vector<Part> &parts)
  {
    pictures_.push_back({time, parts});
    write_file_atomically(path_,
                          [this](std::ostream &out) {
                            out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                                   "  <Collection>\n";
                            for (const auto &[when, all] : pictures_)
                              for (std::size_t part = 0; part < all.size(); ++part)
                                out << "    <DataSet timestep=\"" << text::format(when) << "\" part=\"" << part
                                    << "\" name=\"" << xml_attribute(all[part].name) << "\" file=\"" << all[part].file
                                    << "\"/>\n";
                            out << "  </Collection>\n</VTKFile>\n";
                          });
  }
} // namespace deltaform
