// SPDX-License-Identifier: BSD-3-Clause
//
// The world and the checks of its results; the steps that change it are in LifetimeSteps.cxx.
#include "LifetimeWorld.h"

#include "FilterJudge.h"
#include "MeshJudge.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkAdaptiveHilbertInterpolation2D.h"
#include "vtkAdaptiveHilbertQualityMesh2D.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace ahd
{
namespace fuzz
{

const LifetimeWorld::Kind LifetimeWorld::kKinds[] = {
  { "updateSurface", &LifetimeWorld::updateSurface },
  { "updateRaster", &LifetimeWorld::updateRaster },
  { "updateSurface", &LifetimeWorld::updateSurface }, // twice as often as others
  { "updateRaster", &LifetimeWorld::updateRaster },
  { "movePoints", &LifetimeWorld::movePoints },
  { "movePoints", &LifetimeWorld::movePoints },
  { "updatePieces", &LifetimeWorld::updatePieces },
  { "interpolateOnOutput", &LifetimeWorld::interpolateOnOutput },
  { "updateInThreads", &LifetimeWorld::updateInThreads },
  { "setSurface", &LifetimeWorld::setSurface },
  { "setRaster", &LifetimeWorld::setRaster },
  { "setTransform", &LifetimeWorld::setTransform },
  { "connect", &LifetimeWorld::connect },
  { "giveTime", &LifetimeWorld::giveTime },
  { "addConsumer", &LifetimeWorld::addConsumer },
  { "deleteConsumer", &LifetimeWorld::deleteConsumer },
  { "newFilter", &LifetimeWorld::newFilter },
  { "newInput", &LifetimeWorld::newInput },
  { "changeInPlace", &LifetimeWorld::changeInPlace },
  { "copyInput", &LifetimeWorld::copyInput },
  { "changeData", &LifetimeWorld::changeData },
  { "newSource", &LifetimeWorld::newSource },
  { "changeSource", &LifetimeWorld::changeSource },
  { "lieInSource", &LifetimeWorld::lieInSource },
  { "editOutput", &LifetimeWorld::editOutput },
  { "dropOutput", &LifetimeWorld::dropOutput },
  { "abort", &LifetimeWorld::abort },
  { "changeInObserver", &LifetimeWorld::changeInObserver },
  { "setNumbers", &LifetimeWorld::setNumbers },
  { "setNumbers", &LifetimeWorld::setNumbers },
  { "updateMesh", &LifetimeWorld::updateMesh },
  { "updateMesh", &LifetimeWorld::updateMesh },
  { "setMesh", &LifetimeWorld::setMesh },
  { "newMesh", &LifetimeWorld::newMesh },
};

std::size_t LifetimeWorld::kinds()
{
  return sizeof kKinds / sizeof kKinds[0];
}

const char* LifetimeWorld::name(std::size_t kind)
{
  return kKinds[kind].name;
}

LifetimeWorld::LifetimeWorld()
  : surface_(vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D>::New())
  , raster_(vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D>::New())
  , mesh_(vtkSmartPointer<vtkAdaptiveHilbertQualityMesh2D>::New())
{
  Dice dice(0);
  input_ = makeInput(dice);
  this->attach();
}

LifetimeWorld::~LifetimeWorld() = default;

void LifetimeWorld::step(std::size_t kind, Dice& dice)
{
  (this->*kKinds[kind].step)(dice);
}

void LifetimeWorld::finish()
{
  Dice dice(1);
  this->updateSurface(dice);
  this->updateRaster(dice);
  if (hasMesh_)
  {
    this->updateMesh(dice);
  }
}

std::string LifetimeWorld::state() const
{
  const char* routes[] = { "data", "surface", "stream" };
  std::string text = std::string(routes[route_]) + ", time " + std::to_string(int(time_)) +
    (source_ ? ", source" : "") + (transform_ ? ", transform" : "") + ", settings";
  for (const std::uint8_t setting : settings_)
  {
    text += " " + std::to_string(setting);
  }
  return text;
}

namespace
{

void expectSame(const char* what, const std::string& found, const std::string& wanted)
{
  if (found != wanted)
  {
    const auto at = std::size_t(
      std::mismatch(found.begin(), found.end(), wanted.begin(), wanted.end()).first -
      found.begin());
    std::fprintf(stderr,
      "%s: not what a new filter gives: at %zu of %zu and %zu bytes\n%.300s\nfor\n%.300s\n", what,
      at, found.size(), wanted.size(), found.c_str() + at, wanted.c_str() + at);
    std::abort();
  }
}

/// On a surface weights come from its triangulation or, if that is not available, from its own
/// triangles, whose corners begin elsewhere.
void expectClose(const char* what, vtkDataObject* found, vtkDataObject* wanted)
{
  if (!areClose(found, wanted))
  {
    expectSame(what, rasterText(found), rasterText(wanted));
  }
}

} // namespace

void LifetimeWorld::configure(vtkAdaptiveHilbertDelaunay2D* surface) const
{
  surface->SetSourceMode(settings_[0] % 2);
  surface->SetCrossingMode(settings_[1] % 2);
  surface->SetProjectionPlaneMode(transform_ ? 1 : settings_[2] % 3 == 1 ? 2 : 0);
  surface->SetTransform(transform_);
  surface->SetKeepTriangulation(settings_[3] % 3 != 1);
  surface->SetGenerateRegionIds(settings_[4] % 2 == 1);
  surface->SetGenerateNeighbors(settings_[5] % 2 == 1);
  surface->SetDuplicatePolicy(settings_[6] % 4);
  // without it a copied or passed-on surface has less information than its triangulation
  surface->SetGenerateConstraintEdges(true);
  surface->SetNumberOfThreads(1 + settings_[7] % 2);
  this->configureNumbers(surface);
}

/// A surface of some of the points, and its errors.
void LifetimeWorld::configureNumbers(vtkAdaptiveHilbertDelaunay2D* surface) const
{
  const double errors[] = { 0.0, 0.02, 0.1, 0.4 };
  const double most = errors[settings_[12] % 4];
  const int vertices = settings_[13] % 3 == 1 ? 20 : 0;
  surface->SetMaximumError(most);
  surface->SetMaximumNumberOfVertices(vertices);
  surface->SetSecondPass(settings_[14] % 2 == 1);
  surface->SetKeptPointsOnly(settings_[15] % 3 != 1);
  surface->SetGenerateErrors(settings_[16] % 3 == 1);
  surface->SetValueArrayName(settings_[17] % 3 == 1 ? "h" : "");
  surface->SetWeightArrayName(settings_[17] % 4 == 2 ? "h" : "");
  surface->SetKeepArrayName(settings_[17] % 5 == 3 ? "vtkGhostType" : "");
  if (most > 0.0 || vertices > 0) // means of heights exclude it
  {
    surface->SetDuplicatePolicy(settings_[6] % 3);
  }
}

void LifetimeWorld::configure(vtkAdaptiveHilbertQualityMesh2D* mesh) const
{
  const double angles[] = { 20.0, 0.0, 30.0 };
  this->configure(mesh->GetTriangulation());
  mesh->SetMinimumAngle(angles[settings_[18] % 3]);
  mesh->SetMaximumLength(settings_[19] % 3 == 1 ? 0.3 : 0.0);
  mesh->SetSizeArrayName(settings_[20] % 3 == 1 ? "h" : "");
  mesh->SetMaximumNumberOfAddedPoints(100);
}

void LifetimeWorld::configure(
  vtkAdaptiveHilbertDelaunay2D* surface, vtkAdaptiveHilbertInterpolation2D* raster) const
{
  this->configure(surface);
  this->configure(raster->GetTriangulation());
  raster->SetDimensions(9, 7);
  // natural neighbours and the nearest vertex end elsewhere than in the triangulation of a surface,
  // as its own triangles tell less about constraints
  raster->SetMethod(route_ == kSurface && source_ ? 0 : settings_[8] % 4);
  raster->SetOutside(settings_[9] % 2);
  raster->SetUseBounds(settings_[10] % 2 == 1);
  raster->SetBounds(0.1, 0.8, 0.2, 0.9);
  raster->SetOutputType(settings_[11] % 4 == 1);
}

/// Sets everything by route and settings.
void LifetimeWorld::attach()
{
  isCurrent_ = false;
  this->configure(surface_, raster_);
  this->configure(mesh_);
  surface_->SetSourceData(source_);
  raster_->SetSourceData(route_ == kSurface ? nullptr : source_.Get());
  mesh_->SetSourceData(route_ == kSurface ? nullptr : source_.Get());
  if (route_ == kStream)
  {
    stream_ = stream_ ? stream_ : vtkSmartPointer<TimedPoints>::New();
    surface_->SetInputConnection(0, stream_->GetOutputPort());
    raster_->SetInputConnection(0, stream_->GetOutputPort());
    mesh_->SetInputConnection(0, stream_->GetOutputPort());
    return;
  }
  surface_->SetInputDataObject(0, input_);
  if (route_ == kData)
  {
    raster_->SetInputDataObject(0, input_);
    mesh_->SetInputDataObject(0, input_);
  }
  else
  {
    raster_->SetInputConnection(0, surface_->GetOutputPort(0));
    mesh_->SetInputConnection(0, surface_->GetOutputPort(0));
  }
}

void LifetimeWorld::inputModified()
{
  if (stream_)
  {
    stream_->Modified();
  }
  if (input_->GetPoints())
  {
    input_->GetPoints()->GetData()->Modified();
    input_->GetPoints()->Modified();
  }
  input_->Modified();
}

vtkSmartPointer<vtkPolyData> LifetimeWorld::inputNow() const
{
  if (route_ != kStream)
  {
    return copyOf(input_);
  }
  auto made = vtkSmartPointer<vtkPolyData>::New();
  TimedPoints::make(time_, 0, 1, made);
  return made;
}

/// New filters with the same settings, of copies of the inputs.
void LifetimeWorld::makeNew(vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D>& surface,
  vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D>& raster) const
{
  surface = vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D>::New();
  raster = vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D>::New();
  this->configure(surface, raster);
  const auto given = this->inputNow();
  surface->SetInputDataObject(0, given);
  surface->SetSourceData(source_ ? copyOf(source_).Get() : nullptr);
  if (route_ == kSurface)
  {
    raster->SetInputConnection(0, surface->GetOutputPort(0));
    return;
  }
  raster->SetInputDataObject(0, given);
  raster->SetSourceData(source_ ? copyOf(source_).Get() : nullptr);
}

void LifetimeWorld::bringUpToDate(vtkAlgorithm* filter, Dice& dice) const
{
  if (route_ == kStream)
  {
    filter->UpdateTimeStep(time_);
  }
  filter->UpdateWholeExtent();
  if (route_ == kStream || dice.below(2) == 0)
  {
    filter->Update();
  }
}

void LifetimeWorld::checkSurface()
{
  vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> surface;
  vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D> raster;
  this->makeNew(surface, raster);
  surface->Update();
  expectSame("surface", outputsOf(surface_), outputsOf(surface));
  isCurrent_ = true;
}

void LifetimeWorld::checkRaster(bool isWhole)
{
  vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> surface;
  vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D> raster;
  this->makeNew(surface, raster);
  raster->Update();
  vtkDataObject* const found = raster_->GetOutputDataObject(0);
  vtkDataObject* const wanted = raster->GetOutputDataObject(0);
  auto* image = vtkImageData::SafeDownCast(found);
  auto* all = vtkImageData::SafeDownCast(wanted);
  if (route_ == kSurface && isWhole)
  {
    expectClose("raster behind the surface", found, wanted);
    return;
  }
  if (isWhole || !image || !all)
  {
    expectSame("raster", rasterText(found), rasterText(wanted));
    return;
  }
  expectSame("piece", partText(image, image->GetExtent()), partText(all, image->GetExtent()));
}

void LifetimeWorld::checkMesh()
{
  vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> surface;
  vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D> raster;
  this->makeNew(surface, raster);
  vtkNew<vtkAdaptiveHilbertQualityMesh2D> mesh;
  this->configure(mesh);
  if (route_ == kSurface)
  {
    mesh->SetInputConnection(0, surface->GetOutputPort(0));
  }
  else
  {
    mesh->SetInputDataObject(0, raster->GetInputDataObject(0, 0));
    mesh->SetSourceData(raster->GetSource());
  }
  mesh->Update();
  expectSame("mesh", outputsOf(mesh_), outputsOf(mesh));
}

void LifetimeWorld::updateSurface(Dice& dice)
{
  for (std::size_t times = 1 + dice.below(3); times > 0; --times)
  {
    if (dice.below(4) != 0)
    {
      input_->Modified();
    }
    this->bringUpToDate(surface_, dice);
    this->checkSurface();
  }
}

void LifetimeWorld::updateRaster(Dice& dice)
{
  if (dice.below(2) == 0)
  {
    raster_->Modified();
  }
  this->bringUpToDate(raster_, dice);
  this->checkRaster(true);
}

void LifetimeWorld::updateMesh(Dice& dice)
{
  hasMesh_ = true;
  if (dice.below(2) == 0)
  {
    input_->Modified();
    isCurrent_ = false;
  }
  this->bringUpToDate(mesh_, dice);
  this->checkMesh();
}

/// As writers of pieces request a raster.
void LifetimeWorld::updatePieces(Dice& dice)
{
  if (route_ == kStream) // at the time that a piece without one gets
  {
    time_ = 0.0;
    raster_->UpdateTimeStep(time_);
  }
  const int count = 2 + int(dice.below(2));
  for (int piece = 0; piece < count && settings_[11] % 4 != 1; ++piece)
  {
    raster_->UpdatePiece(piece, count, 0);
    this->checkRaster(false);
  }
  raster_->UpdateWholeExtent();
}

/// On the current surface, where a new filter may find its triangulation, and on that of a new
/// filter.
void LifetimeWorld::interpolateOnOutput(Dice&)
{
  if (!isCurrent_ || route_ == kStream)
  {
    return;
  }
  vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> surface;
  vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D> notUsed;
  this->makeNew(surface, notUsed);
  surface->Update();
  vtkNew<vtkAdaptiveHilbertInterpolation2D> rasters[2];
  for (int k : { 0, 1 })
  {
    rasters[k]->SetDimensions(9, 7);
    rasters[k]->SetInputDataObject(0, (k == 0 ? surface_ : surface)->GetOutput());
    rasters[k]->Update();
  }
  expectClose(
    "raster on an output", rasters[0]->GetOutputDataObject(0), rasters[1]->GetOutputDataObject(0));
}

/// Two filters with one input.
void LifetimeWorld::updateInThreads(Dice&)
{
  vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> surfaces[3];
  vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D> raster;
  const auto shared = this->inputNow();
  for (auto& surface : surfaces)
  {
    this->makeNew(surface, raster);
  }
  surfaces[0]->SetInputDataObject(0, shared);
  surfaces[1]->SetInputDataObject(0, shared);
  std::thread other([&] { surfaces[0]->Update(); });
  surfaces[1]->Update();
  other.join();
  surfaces[2]->Update();
  expectSame("surface of a thread", outputsOf(surfaces[0]), outputsOf(surfaces[2]));
  expectSame("surface beside a thread", outputsOf(surfaces[1]), outputsOf(surfaces[2]));
}

} // namespace fuzz
} // namespace ahd
