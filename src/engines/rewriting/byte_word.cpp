#include "engines/rewriting/byte_word.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace filigree::rewriting {
namespace {

// The kernel gives large pages only to who asks; a new word is then written two to three times as fast.
void ask_for_large_pages([[maybe_unused]] std::uint8_t* bytes, [[maybe_unused]] std::size_t size) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::size_t page = std::size_t{2} << 20;
    if (size < 2 * page) return;
    const auto address = reinterpret_cast<std::uintptr_t>(bytes);
    const std::uintptr_t begin = (address + page - 1) / page * page, end = (address + size) / page * page;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // a wish: refused, all goes on as it is
#endif
}

}  // namespace

bool ByteWord::make(std::size_t size) {
    size_ = 0;
    if (size > capacity_) {
        bytes_.reset();
        capacity_ = 0;
        bytes_.reset(static_cast<std::uint8_t*>(std::malloc(size)));
        if (bytes_ == nullptr) return false;
        capacity_ = size;
        ask_for_large_pages(bytes_.get(), size);
    }
    size_ = size;
    return true;
}

}  // namespace filigree::rewriting
