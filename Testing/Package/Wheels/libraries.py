#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a shared library needs of others and gives to others: of ELF, by the compiler's nm and LLVM's llvm-readobj; of
Windows and macOS, by LLVM's llvm-readobj and llvm-objdump (Debian: llvm).

    python libraries.py LIBRARY HEADER...    exports the functions that the headers declare, and nothing else?
"""

import hashlib
import re
import struct
import subprocess
import sys

# The linker of zig adds these to every library for macOS; nothing can bind to them by mistake.
OF_THE_LINKER = {"___dso_handle", "__mh_dylib_header"}


def said(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def kind(path):
    """ELF, PE or Mach-O."""
    with open(path, "rb") as file:
        magic = file.read(4)
    kinds = {b"\x7fELF": "ELF", b"MZ": "PE", b"\xcf\xfa\xed\xfe": "Mach-O"}
    return next(name for begin, name in kinds.items() if magic.startswith(begin))


def exports(path):
    """The names as in C."""
    if kind(path) == "ELF":
        return {line.split()[-1].split("@")[0] for line in said("nm", "-D", "--defined-only", path).splitlines()}
    if kind(path) == "PE":
        return set(re.findall(r"^ +Name: (\S+)$", said("llvm-readobj", "--coff-exports", path), re.MULTILINE))
    names = re.findall(r"^0x\w+ +(\S+)", said("llvm-objdump", "--macho", "--exports-trie", path), re.MULTILINE)
    return {re.sub("^_", "", name) for name in names if name not in OF_THE_LINKER}


def needed(path):
    """Files of other libraries, as the system looks for them."""
    if kind(path) == "ELF":
        return set(re.findall(r"^ +(\S+)$", said("llvm-readobj", "--needed-libs", path).split("[")[1], re.MULTILINE))
    if kind(path) == "PE":
        return set(re.findall(r"^ +Name: (\S+)$", said("llvm-readobj", "--coff-imports", path), re.MULTILINE))
    return set(re.findall(r"^\t(\S+)", said("llvm-objdump", "--macho", "--dylibs-used", path), re.MULTILINE)[1:])


def declared(headers):
    names = set()
    for header in headers:
        with open(header, encoding="utf-8") as file:
            names |= set(re.findall(r"^AHD_API .*?\b(ahd_\w+)\(", file.read(), re.MULTILINE))
    return names


def check_exports(path, headers):
    found, wanted = exports(path), declared(headers)
    assert len(wanted) > 20, wanted
    assert found == wanted, "%s: too many: %s, missing: %s" % (path, sorted(found - wanted), sorted(wanted - found))
    print("%d functions are exported, and nothing else: %s" % (len(found), path))


def least_macos(path):
    """The version of macOS that its load commands name."""
    commands = said("llvm-objdump", "--macho", "--private-headers", path)
    return re.search(r"LC_(?:BUILD_VERSION|VERSION_MIN_MACOSX)(?:\n.*){1,4}?\n +(?:minos|version) (\S+)", commands)[1]


def check_signature(path):
    """Signed ad hoc, without which arm64 runs nothing, and not changed since: each page has the signed hash."""
    commands = said("llvm-objdump", "--macho", "--private-headers", path)
    begin = int(re.search(r"LC_CODE_SIGNATURE\n.*\n +dataoff (\d+)", commands)[1])
    with open(path, "rb") as file:
        data = file.read()
    magic, _size, count = struct.unpack_from(">3I", data, begin)
    assert magic == 0xFADE0CC0 and count > 0, hex(magic)
    directory = begin + struct.unpack_from(">2I", data, begin + 12)[1]
    magic, _size, _version, flags, hashes, _name, _others, pages, end = struct.unpack_from(">9I", data, directory)
    size, of_what, _platform, log2 = struct.unpack_from("4B", data, directory + 36)
    assert magic == 0xFADE0C02 and flags & 2, "not signed ad hoc: %x, %x" % (magic, flags)
    assert (size, of_what, end) == (32, 2, begin), (size, of_what, end, begin)  # SHA-256, of all before the signature
    for i in range(pages):
        at = directory + hashes + size * i
        page = data[i << log2 : min((i + 1) << log2, end)]
        assert data[at : at + size] == hashlib.sha256(page).digest(), "page %d differs from what was signed" % i
    assert pages << log2 >= end, (pages, end)
    print("signed ad hoc, %d pages: %s" % (pages, path))


if __name__ == "__main__":
    check_exports(sys.argv[1], sys.argv[2:])
