// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobSettings_h
#define ahd_JobSettings_h

#include "../Constraints.h"
#include "../Options.h"
#include "../Sample/Sample.h"
#include "../Surface/Plane.h"
#include "../Surface/Selection.h"
#include "../Voronoi/Voronoi.h"
#include "SettingRows.h"
#include "Words.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// The settings of a job by name, and what follows from them. What is unknown or out of range is
/// refused.
class JobSettings
{
public:
  JobSettings();

  void set(const char* name, std::int64_t value);
  void set(const char* name, double value);
  void get(const char* name, std::int64_t& value) const;
  void get(const char* name, double& value) const;

  /// Null past the last.
  static const char* intName(std::size_t number);
  static const char* doubleName(std::size_t number);

  std::int64_t operator[](IntSetting setting) const { return ints_[std::size_t(setting)]; }
  double operator[](DoubleSetting setting) const { return doubles_[std::size_t(setting)]; }
  bool is(IntSetting setting) const { return (*this)[setting] != 0; }

  /// But for Options::mostBoxes.
  Options options() const;
  SizeLimits limits() const;
  ahd::FillRule fillRule() const { return ahd::FillRule((*this)[IntSetting::FillRule]); }
  ahd::VoronoiClip voronoiClip() const
  {
    return ahd::VoronoiClip((*this)[IntSetting::VoronoiClip]);
  }
  ahd::Duplicates duplicates() const { return ahd::Duplicates((*this)[IntSetting::Duplicates]); }
  bool showsMeans() const { return duplicates() == ahd::Duplicates::MeanZ; }
  PlaneKind plane() const { return PlaneKind((*this)[IntSetting::Plane]); }
  /// Is the plane another than x, y?
  bool isProjected() const { return plane() != PlaneKind::Xy; }
  RimKind rim() const { return RimKind((*this)[IntSetting::Rim]); }
  bool addsBounding() const { return is(IntSetting::Bounding) && !isProjected(); }
  bool limitsSize() const;
  /// May the rim have to be trimmed? The plane says whether it does.
  bool mayTrimRim() const;
  /// Is the rim to be trimmed? `fitted`: the plane, where one is.
  bool trimsRim(const Plane& fitted) const;
  /// May the order be drawn?
  bool drawsOrder() const { return is(IntSetting::WantBoxes) || is(IntSetting::WantCurve); }

private:
  std::array<std::int64_t, kIntSettings> ints_;
  std::array<double, kDoubleSettings> doubles_;
};

} // namespace ahd

#endif
