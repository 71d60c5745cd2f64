// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDMeasuresText_h
#define vtkAHDMeasuresText_h

#include <string>
#include <vector>

/// A measure in the text of all.
struct vtkAHDMeasure
{
  const char* Words; // after the number
  double Value;
  double Before; // a run
  bool IsReal;   // with up to three digits, not a whole number
};

/// "1,234 words", a line each; those with the value that they have before a run are left out, but
/// for the first. Empty if all have.
std::string vtkAHDMeasuresText(const std::vector<vtkAHDMeasure>& measures);

#endif
