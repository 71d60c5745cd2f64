// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankUpdates.h"

#include "Ranks/vtkAHDRanks.h"

#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// When what feeds a filter was modified last; `mtime` if that is later.
vtkMTimeType FindLatest(vtkAlgorithm* filter, vtkInformationVector** inputs, vtkMTimeType mtime)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkExecutive* producer = nullptr;
      int from = 0;
      vtkExecutive::PRODUCER()->Get(inputs[port]->GetInformationObject(i), producer, from);
      vtkMTimeType other = 0;
      if (producer &&
        producer->ComputePipelineMTime(
          nullptr, producer->GetInputInformation(), producer->GetOutputInformation(), from, &other))
      {
        mtime = std::max(mtime, other);
      }
    }
  }
  return mtime;
}

/// What one rank announces.
struct Times
{
  std::vector<double> Steps, Bounds;

  auto fields() { return std::tie(this->Steps, this->Bounds); }
};

void Read(vtkInformation* info, vtkInformationDoubleVectorKey* key, std::vector<double>& values)
{
  const double* const first = info->Get(key);
  values.assign(first, first + (first ? info->Length(key) : 0));
}

void Write(
  const std::vector<double>& values, vtkInformationDoubleVectorKey* key, vtkInformation* info)
{
  values.empty() ? info->Remove(key)
                 : info->Set(key, values.data(), static_cast<int>(values.size()));
}
}

vtkMTimeType vtkAHDRankUpdates::FindMTime(vtkMultiProcessController* controller,
  vtkAlgorithm* filter, vtkMTimeType mtime, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  constexpr std::size_t kPorts = 3; // at most
  enum
  {
    Changed,
    Released,                 // an output, of each port
    Held = Released + kPorts, // the same that is not
    Count = Held + kPorts
  };
  const vtkMTimeType latest = FindLatest(filter, inputs, mtime);
  std::array<int, Count> own = {}, all = {};
  own[Changed] = latest > this->Settled ? 1 : 0;
  const int ports = outputs->GetNumberOfInformationObjects();
  for (int port = 0; port < std::min(ports, static_cast<int>(kPorts)); ++port)
  {
    vtkDataObject* const data = vtkDataObject::GetData(outputs, port);
    own[static_cast<std::size_t>(port) + (data && data->GetDataReleased() ? Released : Held)] = 1;
  }
  controller->AllReduce(own.data(), all.data(), Count, vtkCommunicator::MAX_OP);
  bool mustAll = all[Changed] != 0;
  for (std::size_t port = 0; port < kPorts; ++port)
  {
    // those that have it would wait for nothing, those that have it no more for them
    mustAll = mustAll || (all[Released + port] != 0 && all[Held + port] != 0);
  }
  if (mustAll)
  {
    this->Modified.Modified();
  }
  this->Settle();
  return this->Modified;
}

void vtkAHDRankUpdates::ShareTimes(
  vtkMultiProcessController* controller, vtkAlgorithm* filter, vtkInformationVector* outputs)
{
  vtkAHDRanks ranks(controller);
  std::vector<double> times, bounds;
  ranks.Execute(
    [&]
    {
      std::vector<Times> all;
      if (filter->GetNumberOfInputConnections(0) > 0) // else they are those of the last time
      {
        vtkInformation* const info = outputs->GetInformationObject(0);
        Read(info, Pipeline::TIME_STEPS(), times);
        Read(info, Pipeline::TIME_RANGE(), bounds);
      }
      const auto make = [&](Times& mine)
      {
        mine = { times, bounds };
        return ahd::Status::Ok;
      };
      if (ahd::share(ranks, make, all) != ahd::Status::Ok)
      {
        return; // each as it is
      }
      for (const Times& one : all)
      {
        times.insert(times.end(), one.Steps.begin(), one.Steps.end());
        bounds.insert(bounds.end(), one.Bounds.begin(), one.Bounds.end());
      }
      std::sort(times.begin(), times.end());
      times.erase(std::unique(times.begin(), times.end()), times.end());
      std::sort(bounds.begin(), bounds.end());
      bounds.erase(bounds.begin() + !bounds.empty(), bounds.end() - (bounds.size() > 1));
    });
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* const info = outputs->GetInformationObject(port);
    Write(times, Pipeline::TIME_STEPS(), info);
    Write(bounds, Pipeline::TIME_RANGE(), info);
  }
}
