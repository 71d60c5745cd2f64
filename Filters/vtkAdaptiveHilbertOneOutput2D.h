// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertOneOutput2D
 * @brief   one of the outputs of vtkAdaptiveHilbertDelaunay2D
 *
 * A vtkAdaptiveHilbertDelaunay2D with a single output port, which has what one of its ports has:
 * the surface, the order of insertion or the Voronoi cells. For programs that show all ports of a
 * filter, like ParaView, whose menu has a filter for each of them.
 *
 * @sa
 * vtkAdaptiveHilbertDelaunay2D
 */

#ifndef vtkAdaptiveHilbertOneOutput2D_h
#define vtkAdaptiveHilbertOneOutput2D_h

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkNew.h" // for members

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertOneOutput2D
  : public vtkAdaptiveHilbertDelaunay2D
{
public:
  static vtkAdaptiveHilbertOneOutput2D* New();
  vtkTypeMacro(vtkAdaptiveHilbertOneOutput2D, vtkAdaptiveHilbertDelaunay2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The port of vtkAdaptiveHilbertDelaunay2D whose data the output has, from 0 to 2. The settings
  /// say what it has (GenerateVoronoi, for example). Default 0, the surface.
  vtkSetClampMacro(ShownPort, int, 0, 2);
  vtkGetMacro(ShownPort, int);
  ///@}

  /// Runs vtkAdaptiveHilbertDelaunay2D's with three outputs, of which two are given up.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkAdaptiveHilbertOneOutput2D();
  ~vtkAdaptiveHilbertOneOutput2D() override;

  int ShownPort = 0;

private:
  vtkAdaptiveHilbertOneOutput2D(const vtkAdaptiveHilbertOneOutput2D&) = delete;
  void operator=(const vtkAdaptiveHilbertOneOutput2D&) = delete;

  const vtkNew<vtkInformationVector> All; // the three; two are this filter's own
};

#endif
