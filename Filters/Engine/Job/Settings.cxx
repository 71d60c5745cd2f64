// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include "../Sample/Sample.h"
#include "Refusal.h"

#include <cstring>
#include <locale>
#include <sstream>
#include <string>

namespace ahd
{
namespace
{

template <typename Number, std::size_t count>
std::size_t find(const SettingRow<Number> (&rows)[count], const char* name)
{
  for (std::size_t i = 0; name && i < count; ++i)
  {
    if (std::strcmp(rows[i].name, name) == 0)
    {
      return i;
    }
  }
  return count;
}

template <typename Number, std::size_t count>
std::size_t mustFind(const SettingRow<Number> (&rows)[count], const char* name)
{
  const std::size_t i = find(rows, name);
  if (i < count)
  {
    return i;
  }
  const char* const kind = sizeof(rows) == sizeof(kIntRows) ? "int" : "double";
  const bool isOther = find(kIntRows, name) < kIntSettings ||
    find(kDoubleRows, name) < kDoubleSettings;
  refuse(Reason::UnknownName,
    "There is no setting \"" + std::string(name ? name : "(null)") + "\" of type " + kind +
      (isOther ? ": it is of the other type." : "."));
}

template <typename Number, std::size_t count>
void put(const SettingRow<Number> (&rows)[count], const char* name, Number value, Number* values)
{
  const std::size_t i = mustFind(rows, name);
  if (!(value >= rows[i].least && value <= rows[i].most))
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << "\"" << name << "\" may be " << rows[i].least << " to " << rows[i].most << ", not "
         << value << ".";
    refuse(Reason::BadValue, text.str());
  }
  values[i] = value;
}

} // namespace

JobSettings::JobSettings()
{
  for (std::size_t i = 0; i < kIntSettings; ++i)
  {
    ints_[i] = kIntRows[i].preset;
  }
  for (std::size_t i = 0; i < kDoubleSettings; ++i)
  {
    doubles_[i] = kDoubleRows[i].preset;
  }
}

void JobSettings::set(const char* name, std::int64_t value)
{
  put(kIntRows, name, value, ints_.data());
}

void JobSettings::set(const char* name, double value)
{
  put(kDoubleRows, name, value, doubles_.data());
}

void JobSettings::get(const char* name, std::int64_t& value) const
{
  value = ints_[mustFind(kIntRows, name)];
}

void JobSettings::get(const char* name, double& value) const
{
  value = doubles_[mustFind(kDoubleRows, name)];
}

void JobSettings::wantSamplesOnly()
{
  for (std::size_t i = 0; i < kIntSettings; ++i)
  {
    if (std::strncmp(kIntRows[i].name, "want_", 5) == 0)
    {
      ints_[i] = i == std::size_t(IntSetting::WantSamples);
    }
  }
}

void JobSettings::leaveToSurface()
{
  for (const auto& used : kIntsOnSurface)
  {
    set(used.setting, used.value);
  }
  for (const auto& used : kDoublesOnSurface)
  {
    set(used.setting, used.value);
  }
}

const char* JobSettings::intName(std::size_t number)
{
  return number < kIntSettings ? kIntRows[number].name : nullptr;
}

const char* JobSettings::doubleName(std::size_t number)
{
  return number < kDoubleSettings ? kDoubleRows[number].name : nullptr;
}

RunSettings JobSettings::run() const
{
  RunSettings run;
  read(run);
  run.options.keepOrder = run.options.keepOrder || run.wants(WantedArray::InsertionRanks) ||
    run.curve;
  const auto duplicates = Duplicates((*this)[IntSetting::Duplicates]);
  run.options.representative = duplicates == Duplicates::LowestZ ? Representative::LowestZ
    : duplicates == Duplicates::HighestZ                         ? Representative::HighestZ
                                                                 : Representative::FirstId;
  run.showsMeans = duplicates == Duplicates::MeanZ;
  run.idsAreOfInput = !is(IntSetting::CellIds);
  return run;
}

} // namespace ahd
