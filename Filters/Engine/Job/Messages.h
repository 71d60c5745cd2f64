// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Messages_h
#define ahd_Messages_h

#include "../Sample/Sample.h"
#include "RunReport.h"
#include "Words.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ahd
{

/// A number or text in messages. The name is borrowed.
struct Fact
{
  template <typename Number,
    std::enable_if_t<std::is_arithmetic<Number>::value || std::is_enum<Number>::value, int> = 0>
  Fact(std::string_view its, Number value)
    : name(its)
    , number(std::is_floating_point<Number>::value ? 0 : static_cast<std::int64_t>(value))
    , real(std::is_floating_point<Number>::value ? static_cast<double>(value) : double(number))
  {
  }
  Fact(std::string_view its, std::string words, std::int64_t count = 0)
    : name(its)
    , text(std::move(words))
    , number(count)
    , real(static_cast<double>(count))
  {
  }

  std::string_view name;
  std::string text;
  std::int64_t number = 0;
  double real = 0.0;
};

/// Facts by name: counts of a job (ahd.h), and others that Catalogue.h names. A list is several of
/// one name. Missing ones are 0 or empty.
class Facts
{
public:
  Facts(std::initializer_list<Fact> facts = {})
    : facts_(facts)
  {
  }
  void add(Fact fact) { facts_.push_back(std::move(fact)); }
  /// A number, unless it is 0, or there is one of this name among the first `given`.
  template <typename Number>
  void addNonzero(std::string_view name, Number number, std::size_t given = 0)
  {
    if (number != Number() && !isAmong(name, given))
    {
      add({ name, number });
    }
  }
  void reserve(std::size_t count) { facts_.reserve(count); }
  std::size_t count() const { return facts_.size(); }

  /// The first of this name.
  const Fact& of(std::string_view name) const;
  std::int64_t operator[](std::string_view name) const { return of(name).number; }
  std::vector<Fact> all(std::string_view name) const;

private:
  bool isAmong(std::string_view name, std::size_t first) const;

  std::vector<Fact> facts_;
};

/// The facts of a run: its counts in ReportRows.h, and those of refusals. Memory is in bytes.
/// `known` ones take precedence.
Facts factsOf(const RunReport& report, Facts known = Facts());
/// Those of an interpolation.
Facts factsOf(const SampleReport& report, Facts known = Facts());

/// The reason why a run failed. `isRefused`: RunReport's.
Reason reasonOf(Status status, bool isRefused);

/// The names of settings and arrays in a message.
enum class Wording : std::int32_t
{
  Job,   ///< the C interface's; memory in bytes
  Class, ///< those of VTK's classes; memory in KiB
  NumPy  ///< the keywords of delaunay(); memory in bytes
};

/// The occasion of a message.
enum class Topic : std::int32_t
{
  Refusal,       ///< the reason of no result: at most one
  Triangulation, ///< after a run
  Columns,       ///< about arrays to interpolate
  Places,        ///< after an interpolation
  Blocks,        ///< about ignored blocks of data sets
  Outline        ///< after an outline
};

struct Message
{
  const char* name; ///< of the row in Catalogue.h
  std::string text;
};

/// All messages, in their order. Throws std::bad_alloc.
std::vector<Message> messages(Topic topic, Wording wording, Facts facts);

} // namespace ahd

#endif
