#include "face_pressure.h"

namespace deltaform
{
  namespace
  {
    const LoadRegistry::Entry
      entry("dead pressure", "pressure on the initial area and direction", make_as<FacePressure<false>, Load>);
  } // namespace
} // namespace deltaform
