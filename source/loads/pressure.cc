#include "face_pressure.h"

namespace deltaform
{
  namespace
  {
    const LoadRegistry::Entry entry("pressure", "pressure that follows the surface", make_as<FacePressure<true>, Load>);
  } // namespace
} // namespace deltaform
