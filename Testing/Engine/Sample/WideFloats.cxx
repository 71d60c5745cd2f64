// SPDX-License-Identifier: BSD-3-Clause
//
// WideFloat: sums, products and inverses against rationals, for any number of digits, with operands
// near each other and far apart.
#include "Arithmetic/WideFloat.h"
#include "Random.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace ahd
{
namespace test
{
namespace
{

mpq_class powerOfTwo(int exponent)
{
  const mpz_class power = mpz_class(1) << static_cast<mp_bitcnt_t>(std::abs(exponent));
  return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}

mpq_class valueOf(const WideFloat& a)
{
  mpz_class whole;
  mpz_import(
    whole.get_mpz_t(), std::size_t(a.whole.size), -1, sizeof a.whole.word[0], 0, 0, a.whole.word);
  const mpq_class magnitude = whole * powerOfTwo(64 * a.exponent);
  return a.sign() < 0 ? mpq_class(-magnitude) : magnitude;
}

/// Is it wrong by no more than so many units of itself, and are its digits normalised?
void expectNear(
  const WideFloat& found, const mpq_class& expected, const WideArithmetic& with, int units)
{
  const mpq_class off = abs(valueOf(found) - expected);
  ASSERT_TRUE(off <= units * powerOfTwo(with.unit()) * abs(expected)) << with.digits();
  ASSERT_LE(found.whole.size, with.digits());
  if (found.sign() != 0)
  {
    ASSERT_NE(found.whole.word[0], 0u);
    ASSERT_NE(found.whole.word[found.whole.size - 1], 0u);
    ASSERT_TRUE(abs(expected) < powerOfTwo(found.bits() + 1));
    ASSERT_TRUE(abs(valueOf(found)) < powerOfTwo(found.bits()));
    ASSERT_TRUE(abs(valueOf(found)) >= powerOfTwo(found.bits() - 1));
    const mpq_class lead = mpq_class(found.leading()) * powerOfTwo(64 * found.leadingExponent());
    ASSERT_TRUE(abs(lead - abs(valueOf(found))) <= powerOfTwo(-51) * lead);
  }
}

/// Any finite double: of any exponent, or near 1, or with few bits.
double anyDouble(Random& random)
{
  const double unit = random.unit() - 0.5;
  const int exponents[] = { 0, int(random.below(8)), int(random.below(2000)) - 1020 };
  const double value = std::ldexp(unit, exponents[random.below(3)]);
  return random.below(4) == 0 ? std::ldexp(1.0, std::ilogb(value)) : value;
}

TEST(WideFloats, DifferencesOfDoubles)
{
  Random random(1);
  const auto with = std::make_unique<WideArithmetic>();
  WideFloat found;
  for (int k = 0; k < 3000; ++k)
  {
    with->setDigits(2 + int(random.below(40)));
    const double a = anyDouble(random), b = random.below(9) == 0 ? a : anyDouble(random);
    with->difference(a, b, found);
    ASSERT_NO_FATAL_FAILURE(expectNear(found, mpq_class(a) - mpq_class(b), *with, 1));
  }
}

/// Of products of differences; each is within its units of the operands that went in.
TEST(WideFloats, SumsProductsAndInverses)
{
  Random random(2);
  const auto with = std::make_unique<WideArithmetic>();
  for (int k = 0; k < 3000; ++k)
  {
    with->setDigits(k % 100 == 0 ? kMostDigits : 2 + int(random.below(30)));
    WideFloat a, b, c;
    with->difference(anyDouble(random), anyDouble(random), a);
    with->difference(anyDouble(random), anyDouble(random), b);
    for (int i = 0; i < 5; ++i)
    {
      const mpq_class A = valueOf(a), B = valueOf(b);
      with->product(a, b, c);
      ASSERT_NO_FATAL_FAILURE(expectNear(c, A * B, *with, 1));
      const mpq_class C = valueOf(c);
      with->sum(c, a, b);
      ASSERT_NO_FATAL_FAILURE(expectNear(b, C + A, *with, 1));
      const mpq_class sum = valueOf(b);
      with->difference(b, c, a); // nearly what it was
      ASSERT_NO_FATAL_FAILURE(expectNear(a, sum - C, *with, 1));
      if (c.sign() != 0)
      {
        with->inverse(c, c);
        ASSERT_NO_FATAL_FAILURE(expectNear(c, 1 / C, *with, 4));
      }
      a = c;
    }
  }
}

TEST(WideFloats, AResultMayBeAnOperand)
{
  Random random(3);
  const auto with = std::make_unique<WideArithmetic>();
  for (int k = 0; k < 500; ++k)
  {
    with->setDigits(2 + int(random.below(10)));
    WideFloat a, b;
    with->difference(anyDouble(random), anyDouble(random), a);
    with->difference(anyDouble(random), anyDouble(random), b);
    const mpq_class A = valueOf(a), B = valueOf(b);
    WideFloat first = a, second = b, both = a;
    with->difference(first, b, first);
    ASSERT_NO_FATAL_FAILURE(expectNear(first, A - B, *with, 1));
    with->difference(a, second, second);
    ASSERT_NO_FATAL_FAILURE(expectNear(second, A - B, *with, 1));
    with->product(both, both, both);
    ASSERT_NO_FATAL_FAILURE(expectNear(both, A * A, *with, 1));
    both = b;
    with->sum(both, both, both);
    ASSERT_NO_FATAL_FAILURE(expectNear(both, 2 * B, *with, 1));
  }
}

} // namespace
} // namespace test
} // namespace ahd
