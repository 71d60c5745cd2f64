// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSetters_h
#define vtkAHDSetters_h

#include "vtkObject.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

/// Sets it to the nearest of these values; NaN has none and changes nothing.
inline void vtkAHDSetClamped(
  vtkObject* owner, double& setting, double value, double least, double most)
{
  const double nearest = std::min(std::max(value, least), most);
  if (!std::isnan(value) && nearest != setting)
  {
    setting = nearest;
    owner->Modified();
  }
}

/// By bits: NaN is not equal to itself, but it is no other setting either.
inline void vtkAHDSetAny(vtkObject* owner, double& setting, double value)
{
  if (std::memcmp(&setting, &value, sizeof value) != 0)
  {
    setting = value;
    owner->Modified();
  }
}

inline void vtkAHDSetAny(vtkObject* owner, std::string& setting, const std::string& value)
{
  if (setting != value)
  {
    setting = value;
    owner->Modified();
  }
}

#endif
