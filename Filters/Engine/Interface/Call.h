// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Call_h
#define ahd_Call_h

#include "../Job/Job.h"
#include "../Job/Refusal.h"
#include "Translate.h"
#include "ahd.h"

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

// How a call of the C interface comes to its job: handles and pointers are checked, exceptions
// become a status and a message.

struct ahd_job
{
  ahd::Job job;
  std::string message;
  /// The message, or what to say without memory for it. Atomic, as a call from a callback may be on
  /// another thread than the one that is at work, though it must not.
  std::atomic<const char*> said{ "" };
  std::atomic<bool> isBusy{ false };
};

namespace ahd
{
namespace calls
{

/// Says why the call failed.
inline void say(ahd_job& job, std::string&& text)
{
  job.message = std::move(text);
  job.said = job.message.c_str();
}

/// Calls work(the job); exceptions become a status and a message.
template <typename Work>
ahd_status guarded(ahd_job& job, const Work& work)
{
  job.said = "";
  try
  {
    work(job.job);
    job.said = ""; // a callback's calls may have set the message that it is busy
    return AHD_OK;
  }
  catch (ahd::Refusal& refusal)
  {
    say(job, std::move(refusal.text));
    return static_cast<ahd_status>(refusal.reason);
  }
  catch (const std::bad_alloc&)
  {
    job.said = "Out of memory.";
    return AHD_OUT_OF_MEMORY;
  }
  catch (const std::length_error&)
  {
    job.said = "Out of memory.";
    return AHD_OUT_OF_MEMORY;
  }
  catch (...)
  {
    job.said = "A fault of the library.";
    return AHD_FAILED;
  }
}

template <typename Work>
ahd_status call(ahd_job* job, const Work& work)
{
  if (!job)
  {
    return AHD_NO_JOB;
  }
  if (job->isBusy.exchange(true))
  {
    job->said = "The job is at work: a callback of its can call ahd_cancel() only.";
    return AHD_BUSY;
  }
  job->job.progress.beginCall(job->job.settings[ahd::DoubleSetting::ProgressDelay]);
  const ahd_status status = guarded(*job, work);
  job->job.progress.endCall(status == AHD_CANCELLED);
  job->isBusy = false;
  return status;
}

using ahd::mustHave;

/// Writes what work(the job) returns to `value`.
template <typename Value, typename Work>
ahd_status give(ahd_job* job, Value* value, const char* what, const Work& work)
{
  return call(job,
    [&](ahd::Job& own)
    {
      mustHave(value, what);
      *value = work(own);
    });
}

} // namespace calls
} // namespace ahd

#endif
