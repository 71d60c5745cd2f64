// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Preparation_h
#define ahd_Preparation_h

#include "../Core/Progress.h"
#include "../Crossings/Crossings.h"
#include "HeightSurface.h"
#include "Prepare.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ahd
{

/// Presents several pieces of work to the caller as one phase: it begins once, and its fraction
/// does not fall. `caller` may be null.
class JoinedPhases : public Progress
{
public:
  explicit JoinedPhases(Progress* caller)
    : caller_(caller)
  {
  }

  void beginPhase(Phase phase) override
  {
    if (!inPhase_ || phase != phase_)
    {
      inPhase_ = true;
      phase_ = phase;
      fraction_ = 0.0;
      if (caller_)
      {
        caller_->beginPhase(phase);
      }
    }
  }

  bool advance(Phase phase, double fraction) override
  {
    fraction_ = std::max(fraction_, fraction);
    return !caller_ || caller_->advance(phase, fraction_);
  }

  bool take(std::size_t bytes) override { return !caller_ || caller_->take(bytes); }
  void giveBack(std::size_t bytes) override
  {
    if (caller_)
    {
      caller_->giveBack(bytes);
    }
  }

private:
  Progress* caller_;
  bool inPhase_ = false;
  Phase phase_ = Phase::Merge;
  double fraction_ = 0.0; ///< of the phase
};

/// One call of prepare(). The steps may throw std::bad_alloc and std::length_error.
class Preparation
{
public:
  Preparation(const InputRequest& request, const Context& context, PreparedInput& out)
    : request_(request)
    , out_(out)
    , phases_(context.progress)
    , context_{ &phases_, context.executor }
  {
  }

  Status run();

private:
  // In this order; those that have nothing to do begin no phase.
  Status open();    // the input's points, then the source's
  Status project(); // moves all into the plane
  Status findSourceBounds();
  Status takeHeights();     // of the source, from a surface
  Status merge();           // leaves out those near others
  Status readConstraints(); // in the ids of the points
  Status layLines();        // adds points to them
  Status addBounding();     // the eight around all
  Status split();           // adds the crossings

  bool isMissing(std::size_t sourcePoint) const;
  bool keepsHeight(std::size_t id) const;
  bool isOnSurface(Index from, Index to) const;
  bool isOnSurface(const CrossingPoint::Side& side) const;
  Status triangulateSurface();
  Status constrainSurface(const Context& context);
  Status layOn();
  bool copy(Phase phase);
  double* makeRoom();
  double* add(std::size_t count);
  void look(const double* places);
  void setSkipped(std::vector<unsigned char>&& skip);
  bool readCells(const CellsView& cells, Ticker& ticker);
  template <typename Number>
  bool readCells(const Number* offsets, const Number* ids, std::size_t cells, Ticker& ticker);
  void readId(std::int64_t id);
  bool followMerged(Ticker& ticker);
  bool readPoints(Ticker& ticker);
  bool closeLines(Ticker& ticker);
  bool countFlatChains(Ticker& ticker);
  void addCrossings(const std::vector<CrossingPoint>& points);
  std::array<Index, 2> endsOf(std::size_t chain, std::size_t segment) const;

  const InputRequest& request_;
  PreparedInput& out_;
  JoinedPhases phases_;
  Context context_;                          ///< the caller's, with phases_
  std::int64_t firstId_ = 0;                 ///< the point that the id 0 in a cell names
  std::int64_t idCount_ = 0;                 ///< ids in cells that are a point's: 0 to idCount_ - 1
  std::unique_ptr<HeightSurface> surface_;   ///< until lines are laid on it
  std::vector<unsigned char> withoutHeight_; ///< marks of the points that are not part of it
  std::vector<unsigned char> areOnSurface_;  ///< of each id in the chains, if lines were laid
};

} // namespace ahd

#endif
