// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDMeasuresText.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <locale>
#include <sstream>

namespace
{
/// In the notation of C, whatever the program's locale; thousands of a whole number with commas.
std::string number(const vtkAHDMeasure& measure)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  if (measure.IsReal)
  {
    stream << std::setprecision(3) << measure.Value;
    return stream.str();
  }
  stream << static_cast<long long>(measure.Value);
  std::string digits = stream.str();
  for (std::size_t end = digits.size(); end > 3; end -= 3)
  {
    digits.insert(end - 3, ",");
  }
  return digits;
}

bool isAsBefore(const vtkAHDMeasure& measure)
{
  return measure.Value == measure.Before;
}
}

std::string vtkAHDMeasuresText(const std::vector<vtkAHDMeasure>& measures)
{
  std::string text;
  const bool areShown = !std::all_of(measures.begin(), measures.end(), isAsBefore);
  for (std::size_t k = 0; k < measures.size(); ++k)
  {
    if (areShown && (k == 0 || !isAsBefore(measures[k])))
    {
      text += (k == 0 ? "" : "\n") + number(measures[k]) + " " + measures[k].Words;
    }
  }
  return text;
}
