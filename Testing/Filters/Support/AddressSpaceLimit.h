// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_AddressSpaceLimit_h
#define ahd_AddressSpaceLimit_h

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace ahdtest
{

/// While it lives, the process may take so many more bytes of address space.
class AddressSpaceLimit
{
public:
  explicit AddressSpaceLimit(std::size_t more)
  {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &this->Before);
    rlimit limit = this->Before;
    limit.rlim_cur = pages * std::size_t(sysconf(_SC_PAGESIZE)) + more;
    this->Works = setrlimit(RLIMIT_AS, &limit) == 0;
  }
  ~AddressSpaceLimit() { setrlimit(RLIMIT_AS, &this->Before); }

  bool Works = false;

private:
  rlimit Before;
};

constexpr std::size_t kMegabyte = std::size_t(1) << 20;

} // namespace ahdtest

#endif
