// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobSettings_h
#define ahd_JobSettings_h

#include "RunSettings.h"
#include "SettingRows.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// The settings of a job. By name, unknown ones and values out of range are refused.
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
  /// @pre `value` is in range
  void set(IntSetting setting, std::int64_t value) { ints_[std::size_t(setting)] = value; }
  void set(DoubleSetting setting, double value) { doubles_[std::size_t(setting)] = value; }
  /// Values between points instead of cells: switches want_samples on, and all other want_... off.
  void wantSamplesOnly();
  /// The values that count where values are interpolated on a surface that was made before.
  void leaveToSurface();

  bool is(IntSetting setting) const { return (*this)[setting] != 0; }

  /// The run that they describe.
  RunSettings run() const;

private:
  /// The members of the run that are settings: in ReadSettings.cxx.
  void read(RunSettings& run) const;

  std::array<std::int64_t, kIntSettings> ints_;
  std::array<double, kDoubleSettings> doubles_;
};

} // namespace ahd

#endif
