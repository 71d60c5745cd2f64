// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMNumberOfPointsRangeDomain_h
#define vtkSMNumberOfPointsRangeDomain_h

#include "vtkSMIntRangeDomain.h"

/**
 * @class   vtkSMNumberOfPointsRangeDomain
 * @brief   whole numbers from 3 to the number of points of the input
 *
 * With such a range a property gets a slider in the panel, and an animation of it goes from end to
 * end, from the first number of points that may give a triangle. ParaView has ranges of array
 * values, extents, levels and components, but none of this kind. It needs a required property with
 * the function "Input". It is no reason to change the property's default, and other numbers may be
 * typed (0 stands for all points).
 *
 *     <NumberOfPointsRangeDomain name="range">
 *       <RequiredProperties><Property name="Input" function="Input"/></RequiredProperties>
 *     </NumberOfPointsRangeDomain>
 */
class vtkSMNumberOfPointsRangeDomain : public vtkSMIntRangeDomain
{
public:
  static vtkSMNumberOfPointsRangeDomain* New();
  vtkTypeMacro(vtkSMNumberOfPointsRangeDomain, vtkSMIntRangeDomain);

  void Update(vtkSMProperty* requestingProperty) override;
  int SetDefaultValues(vtkSMProperty*, bool) override { return 0; }

  /// Makes ParaView know the domain. Before any description in XML that uses it is read; once.
  static void Register();

protected:
  vtkSMNumberOfPointsRangeDomain() = default;
  ~vtkSMNumberOfPointsRangeDomain() override = default;

private:
  vtkSMNumberOfPointsRangeDomain(const vtkSMNumberOfPointsRangeDomain&) = delete;
  void operator=(const vtkSMNumberOfPointsRangeDomain&) = delete;
};

#endif
