# SPDX-License-Identifier: BSD-3-Clause
"""The hash of Data/Hashes, and the random numbers of its tests, in Python."""

import struct


class Hash:
    """That of Testing/Support/Run/Hash.h: FNV-1a with 64 bits, each number as eight bytes."""

    def __init__(self):
        self.value = 0xCBF29CE484222325

    def add_bytes(self, octets):
        value = self.value
        for octet in octets:
            value = ((value ^ octet) * 0x100000001B3) & 0xFFFFFFFFFFFFFFFF
        self.value = value

    def add(self, *integers):
        self.add_bytes(struct.pack("<%dq" % len(integers), *integers))

    def add_doubles(self, numbers):
        self.add_bytes(struct.pack("<%dd" % len(numbers), *numbers))

    def text(self):
        return "%016x" % self.value


class Random:
    """Filters/Distributions/Random.h."""

    def __init__(self, seed):
        self.state = seed

    def bits(self):
        mask = 0xFFFFFFFFFFFFFFFF
        self.state = z = (self.state + 0x9E3779B97F4A7C15) & mask
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return z ^ (z >> 31)

    def unit(self):
        return (self.bits() >> 11) * 2.0**-53

    def below(self, n):
        return self.bits() % n

    def bell(self):
        total = -6.0
        for _ in range(12):
            total += self.unit()
        return total
