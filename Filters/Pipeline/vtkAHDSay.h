// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSay_h
#define vtkAHDSay_h

#include "Engine/Job/Messages.h"

#include "vtkAlgorithm.h"

#include <cstdio>
#include <new>

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

/// Calls say(), which says in the name of the filter that memory has run out. If there is none left
/// for that either, a line on the standard error says it, and nothing is thrown.
template <typename Say>
void vtkAHDSayOutOfMemory(const char* filter, const Say& say)
{
  try
  {
    say();
  }
  catch (const std::bad_alloc&)
  {
    std::fprintf(stderr, "%s: out of memory, the output is empty.\n", filter);
  }
}

#endif
