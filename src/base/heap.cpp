#include "base/heap.h"

#include <cstdint>
#include <cstdlib>  // says __GLIBC__
#include <vector>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace filigree {

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

void prepare_heap() {
    constexpr std::size_t block = std::size_t{30} << 20, blocks = 16, page = std::size_t{2} << 20;
    // Below this size arrays come from the heap (glibc allows no more).
    if (mallopt(M_MMAP_THRESHOLD, 32 << 20) == 0 || mallopt(M_TRIM_THRESHOLD, 1 << 30) == 0) return;
    // Blocks that are never touched mark where the heap will grow; freed, they are one range of it again.
    std::vector<void*> reserved;
    for (std::size_t i = 0; i < blocks; ++i) {
        void* const memory = std::malloc(block);
        if (memory == nullptr) break;
        reserved.push_back(memory);
        const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
        const auto end = (reinterpret_cast<std::uintptr_t>(memory) + block) / page * page;
        madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
    }
    for (void* const memory : reserved) std::free(memory);
}

#else

void prepare_heap() {}

#endif

}  // namespace filigree
