// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSay_h
#define vtkAHDSay_h

#include "Engine/Job/Messages.h"

#include "vtkAlgorithm.h"

/// Says what these facts give cause for (Engine/Job/Catalogue.h) in the name of a filter: refusals
/// as errors, all else as warnings. Returns whether anything was said.
inline bool vtkAHDSay(vtkAlgorithm* filter, ahd::Topic topic, const ahd::Facts& facts)
{
  const auto said = ahd::messages(topic, ahd::Wording::Class, facts);
  for (const ahd::Message& message : said)
  {
    if (topic == ahd::Topic::Refusal)
    {
      vtkErrorWithObjectMacro(filter, "" << message.text);
    }
    else
    {
      vtkWarningWithObjectMacro(filter, "" << message.text);
    }
  }
  return !said.empty();
}

#endif
