# SPDX-License-Identifier: BSD-3-Clause
"""The hash of Data/Hashes in Python."""

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
