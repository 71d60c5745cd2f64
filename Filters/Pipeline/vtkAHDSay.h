// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSay_h
#define vtkAHDSay_h

#include "Engine/Job/Messages.h"

#include "vtkAlgorithm.h"

#include <cstdio>
#include <new>

/// Reports the messages about these facts (Engine/Job/Catalogue.h) for a filter: refusals
/// as errors, all others as warnings. Returns whether there were any.
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

/// Calls say(), which reports an error after which the output is empty, as where memory ran out. If
/// there is no memory for that, writes a line to the standard error; throws nothing.
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
