// How much of a forming limit the path of strains of a sheet has used up,
//
//   u = integral of d e1 / L(d e2/d e1),
//
// e1 >= e2 the plastic strains in the plane of the sheet, L(b) the major strain at which a straight path of ratio b
// meets the limit curve (forming_limit.h). On a straight path u is the strain over its limit; a path with corners uses
// up each piece by its own limit (linear accumulation along the path, as in the generalized forming limit of W. Volk,
// J. Suh, AIP Conf. Proc. 1567 (2013) 556). Without flow that stretches, nothing is used.
#include <deltaform/materials/forming_limit.h>
#include <deltaform/materials/point_field.h>
#include <deltaform/parameters/section.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class FormingLimitField : public PointField
    {
    public:
      explicit FormingLimitField(std::unique_ptr<FormingLimit> limit)
        : limit_(std::move(limit))
      {
      }

      Across across() const override
      {
        return Across::middle;
      }

      double growth(const PointStep &step) const override
      {
        const double major = std::max(step.flow[0], step.flow[1]), minor = std::min(step.flow[0], step.flow[1]);
        return major > 0. ? major / limit_->along(minor / major) : 0.;
      }

    private:
      std::unique_ptr<FormingLimit> limit_;
    };

    std::unique_ptr<PointField> make(Section &section, const PointFieldHost &host)
    {
      if (!host.sheet && !section.documentation())
        section.root().sub("Limits").fail("Criteria",
                                          "'forming limit' is a limit of sheets: it is for shells only");
      return std::make_unique<FormingLimitField>(read_forming_limit(section.root(), host.law));
    }

    const PointFields::Entry
      entry("forming limit", "Share of the forming limit that the path of strains has used up; 1: it necks", make);
  } // namespace
} // namespace deltaform
