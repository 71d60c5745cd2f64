// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_LifetimeWorld_h
#define ahd_LifetimeWorld_h

#include "Dice.h"
#include "LifetimeData.h"

#include "vtkAbstractTransform.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkAdaptiveHilbertDelaunay2D;
class vtkAdaptiveHilbertInterpolation2D;
class vtkAdaptiveHilbertQualityMesh2D;

namespace ahd
{
namespace fuzz
{

/// The state of a program: a filter that triangulates, one that interpolates, one that makes a
/// quality mesh, their input and connections. Steps are operations of programs; after any of them
/// the filters give the results of new ones. Where they do not, or the sanitizer finds an invalid
/// access, the program ends.
class LifetimeWorld
{
public:
  LifetimeWorld();
  ~LifetimeWorld();

  /// The number of kinds of steps, and their names.
  static std::size_t kinds();
  static const char* name(std::size_t kind);

  /// `dice`: makes all random choices.
  void step(std::size_t kind, Dice& dice);

  /// Checks at the end.
  void finish();

  /// Route, time and settings, in words.
  std::string state() const;

private:
  using Step = void (LifetimeWorld::*)(Dice&);
  struct Kind
  {
    const char* name;
    Step step;
  };
  static const Kind kKinds[];

  // results
  void updateSurface(Dice& dice);
  void updateRaster(Dice& dice);
  void updateMesh(Dice& dice);
  void updatePieces(Dice& dice);
  void interpolateOnOutput(Dice& dice);
  void updateInThreads(Dice& dice);
  // settings and connections
  void setSurface(Dice& dice);
  void setRaster(Dice& dice);
  void setNumbers(Dice& dice);
  void setMesh(Dice& dice);
  void setTransform(Dice& dice);
  void connect(Dice& dice);
  void giveTime(Dice& dice);
  void addConsumer(Dice& dice);
  void deleteConsumer(Dice& dice);
  void newFilter(Dice& dice);
  void newMesh(Dice& dice);
  // inputs
  void newInput(Dice& dice);
  void changeInPlace(Dice& dice);
  void movePoints(Dice& dice);
  void copyInput(Dice& dice);
  void changeData(Dice& dice);
  void newSource(Dice& dice);
  void changeSource(Dice& dice);
  void lieInSource(Dice& dice);
  // outputs, and while a filter works
  void editOutput(Dice& dice);
  void dropOutput(Dice& dice);
  void abort(Dice& dice);
  void changeInObserver(Dice& dice);

  void configure(
    vtkAdaptiveHilbertDelaunay2D* surface, vtkAdaptiveHilbertInterpolation2D* raster) const;
  void configure(vtkAdaptiveHilbertDelaunay2D* surface) const;
  void configureNumbers(vtkAdaptiveHilbertDelaunay2D* surface) const;
  void configure(vtkAdaptiveHilbertQualityMesh2D* mesh) const;
  void attach();
  void inputModified();
  void makeNew(vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D>& surface,
    vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D>& raster) const;
  vtkSmartPointer<vtkPolyData> inputNow() const;
  void bringUpToDate(vtkAlgorithm* filter, Dice& dice) const;
  void checkSurface();
  void checkRaster(bool isWhole);
  void checkMesh();
  void workWith(vtkAlgorithm* filter, unsigned event, const std::function<void()>& act);
  vtkAlgorithm* oneFilter(Dice& dice);

  vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> surface_;
  vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D> raster_;
  vtkSmartPointer<vtkAdaptiveHilbertQualityMesh2D> mesh_;
  vtkSmartPointer<vtkPolyData> input_, source_;
  vtkSmartPointer<TimedPoints> stream_;
  vtkSmartPointer<vtkAbstractTransform> transform_;
  std::vector<vtkSmartPointer<vtkAlgorithm>> consumers_;
  Lenders lenders_;
  Rubbish rubbish_;
  std::array<std::uint8_t, 21> settings_{}; // 8 of the surface, 4 of the raster, 6 of which points
                                            // it has, 3 of the mesh
  enum Route
  {
    kData,
    kSurface, // the output of the filter that triangulates
    kStream   // a source of time steps and pieces
  } route_ = kData;
  double time_ = 0.0;
  bool isCurrent_ = false; // is the surface that of the input?
  bool hasMesh_ = false;   // was a mesh updated?
};

} // namespace fuzz
} // namespace ahd

#endif
