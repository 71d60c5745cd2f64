# SPDX-License-Identifier: BSD-3-Clause
"""The shortest sequence that still fails."""


def shrink(steps, fails, most=120):
    """Leaves steps out of a list, large parts first, as long as `fails(steps)`. At most so many trials."""
    part = max(1, len(steps) // 2)
    while most > 0:
        begin, dropped = 0, False
        while begin < len(steps) and most > 0:
            fewer = steps[:begin] + steps[begin + part :]
            most -= 1
            if fewer != steps and fails(fewer):
                steps, dropped = fewer, True
            else:
                begin += part
        if part == 1 and not dropped:
            break
        part = part if dropped and part == 1 else max(1, part // 2)
    return steps
