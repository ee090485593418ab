#include <deltaform/materials/hardening.h>
#include <deltaform/materials/rate_factor.h>

namespace deltaform
{
  std::unique_ptr<RateFactor> Hardening::own_rate_factor(double) const
  {
    return nullptr;
  }
} // namespace deltaform
