// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FilterCase_h
#define ahd_FilterCase_h

#include "vtkAbstractTransform.h"
#include "vtkDataObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkAdaptiveHilbertDelaunay2D;
class vtkAdaptiveHilbertQualityMesh2D;

namespace ahd
{
namespace fuzz
{

/// The bytes of a case's head. Zero is the plain choice for each.
enum FilterByte : std::size_t
{
  kInputKind,  ///< see InputKind
  kPointType,  ///< see pointType()
  kPointCount, ///< of the first data set; others have some fewer
  kArrayCount, ///< low 4 bits: of the input; high 4 bits: of the source
  kSourceKind, ///< bit 0 it exists; 1 it has points; 2-7 how many of these
  kCellCount,  ///< of the source
  kModes,  ///< bit 0 source mode; 1 crossing mode; 2 fill rule; 3-4 duplicates; 5-6 plane; 7 merge
  kExtras, ///< fate, constraint edges, regions, neighbours, rank, curve, boxes, Voronoi
  kMoreExtras, ///< to bounds (if not kept: to a polygon), bounding, not kept, no tris, no lines, no
               ///< verts, count work, no genes
  kOrder,      ///< bits 0-1 order; 2-3 control points; 4-7 Nmax, 0 the default
  kPlaneOf,    ///< the transform: 0 none, see transform()
  kAlpha,      ///< a number, see number()
  kEdge,       ///< likewise: MaximumEdgeLength
  kTolerance,  ///< likewise
  kOffset,     ///< likewise
  kLimit,      ///< InsertionLimit
  kMemory,     ///< 0, or MemoryLimit as a number
  kThreadCount,  ///< bits 0-1 NumberOfThreads; 2 closed lines; 3, 7 source heights; 4 points as
                 ///< line; 5 zero is missing; 6 straight lines
  kAbortAt,      ///< a first execution is aborted at this progress event; 0: there is none
  kChange,       ///< changes between executions
  kMultiply,     ///< from 224 on: the points 4, 16, 64 times, side by side
  kMaximumError, ///< a number
  kMostVertices, ///< MaximumNumberOfVertices
  kNumbers,   ///< bits 0-1 values; 2-3 weights; 4-5 marks; 6 second pass; 7 settings that exclude a
              ///< simplified surface or a mesh stay
  kMesh,      ///< 0: the surface; else a quality mesh, its MinimumAngle the byte modulo 35
  kMeshSizes, ///< bits 0-1 sizes; 2-4 length; 5-7 area
  kFilterHeadBytes
};

/// Bytes, one after the other; zeros where there are none left.
class ByteReader
{
public:
  ByteReader(const std::uint8_t* data, std::size_t size)
    : data_(data)
    , end_(data + size)
  {
  }
  std::uint8_t byte() { return data_ == end_ ? std::uint8_t(0) : *data_++; }
  double coordinate();
  vtkIdType id();

private:
  const std::uint8_t* data_;
  const std::uint8_t* end_;
};

/// A setting: 0, powers of two, and special values.
double number(std::uint8_t byte);

/// The filters' inputs. Any bytes are legal: the head, then the points of the input, those of
/// the source, its cells, the arrays. Anything that VTK permits may result.
class FilterCase
{
public:
  FilterCase(const std::uint8_t* data, std::size_t size);

  /// All settings; those without a byte of the head by a byte of another meaning. Those
  /// that change no byte of the result differ between `run` 0 and others.
  void configure(vtkAdaptiveHilbertDelaunay2D* filter, unsigned run) const;
  void configure(vtkAdaptiveHilbertQualityMesh2D* mesh, unsigned run) const;

  /// Changes one of settings, coordinates and data, by the case, each time another.
  void change(unsigned step);

  vtkDataObject* input() const { return input_; }
  vtkPolyData* source() const { return source_; }

  std::uint8_t head(FilterByte byte) const { return head_[byte]; }
  bool bit(FilterByte byte, unsigned which) const { return (head_[byte] >> which & 1) != 0; }

private:
  void readSource(ByteReader& bytes);
  double largest() const;
  std::map<std::string, double> ofSurface() const;          // settings by name
  std::map<std::string, double> ofNumbers() const;          // which points and triangles stay
  std::map<std::string, double> ofWork(unsigned run) const; // how it goes about it

  std::array<std::uint8_t, kFilterHeadBytes> head_{};
  vtkSmartPointer<vtkDataObject> input_;
  vtkSmartPointer<vtkPolyData> source_;
  vtkSmartPointer<vtkAbstractTransform> transform_;
};

/// All data sets in an input or output, blocks of blocks too; those that are missing are left out.
std::vector<vtkDataObject*> leavesOf(vtkDataObject* data);

} // namespace fuzz
} // namespace ahd

#endif
