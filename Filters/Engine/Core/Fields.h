// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Fields_h
#define ahd_Fields_h

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace ahd
{

// Structs that list their members, once for all that is done with each of them:
//     auto fields() { return std::tie(one, other); }

/// Stands for a value of any type, in the initialisation of a struct.
struct AnyValue
{
  template <typename T>
  operator T() const;
};

template <typename Struct, typename Values, typename = void>
struct TakesValues : std::false_type
{
};
template <typename Struct, typename... Values>
struct TakesValues<Struct, std::tuple<Values...>,
  std::void_t<decltype(Struct{ std::declval<Values>()... })>> : std::true_type
{
};

/// How many members an aggregate has; a base is one.
template <typename Struct, typename... Values>
constexpr std::size_t countMembers()
{
  if constexpr (TakesValues<Struct, std::tuple<Values..., AnyValue>>::value)
  {
    return countMembers<Struct, Values..., AnyValue>();
  }
  return sizeof...(Values);
}

/// How many fields() a struct lists.
template <typename Struct>
constexpr std::size_t countFields()
{
  return std::tuple_size<decltype(std::declval<Struct&>().fields())>::value;
}

/// Does an aggregate without a base list all of its members?
template <typename Struct>
constexpr bool listsAll()
{
  return countFields<Struct>() == countMembers<Struct>();
}

/// The same for one with a base that does.
template <typename Struct, typename Base>
constexpr bool listsAllBehind()
{
  return countFields<Struct>() + 1 == countFields<Base>() + countMembers<Struct>();
}

/// Calls change(number of `by`, number of `counts`) for each of them.
template <typename Counts, typename Change>
void changeCounts(const Counts& by, Counts& counts, const Change& change)
{
  std::apply(
    [&](auto&... to)
    {
      std::apply([&](const auto&... from) { (change(from, to), ...); },
        const_cast<Counts&>(by).fields()); // which changes none
    },
    counts.fields());
}

/// Adds each number of `more` to that of `sum`.
template <typename Counts>
void addCounts(const Counts& more, Counts& sum)
{
  changeCounts(more, sum, [](const auto& number, auto& to) { to += number; });
}

/// Subtracts them.
template <typename Counts>
void takeCounts(const Counts& part, Counts& whole)
{
  changeCounts(part, whole, [](const auto& number, auto& from) { from -= number; });
}

} // namespace ahd

#endif
