// A forming limit that was measured.
#include <deltaform/materials/forming_limit.h>
#include <deltaform/parameters/section.h>

#include <stdexcept>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<FormingLimit> read(Section &section, const Material &)
    {
      const std::string name = "Points";
      std::vector<FormingLimit::Point> points;
      for (const auto &row : section.rows(name,
                                          required("-0.2 0.45; 0 0.25; 0.1 0.29; 0.3 0.35"),
                                          2,
                                          "1",
                                          "Rows of minor and major strain, both logarithmic (ln(1 + percent/100))."))
        points.push_back({row[0], row[1]});
      try
      {
        return std::make_unique<FormingLimit>(points);
      }
      catch (const std::invalid_argument &error)
      {
        section.fail(name, error.what());
      }
    }

    const FormingLimits::Entry entry("points", "Measured points, straight between them", read);
  } // namespace
} // namespace deltaform
