#include "engines/rewriting/large_pages.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace filigree::rewriting {

void ask_for_large_pages([[maybe_unused]] void* bytes, [[maybe_unused]] std::size_t size) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::size_t page = std::size_t{2} << 20;
    if (size < 2 * page) return;
    const auto address = reinterpret_cast<std::uintptr_t>(bytes);
    const std::uintptr_t begin = (address + page - 1) / page * page, end = (address + size) / page * page;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace filigree::rewriting
