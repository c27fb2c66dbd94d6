#include "engines/rewriting/byte_word.h"

#include "engines/rewriting/large_pages.h"

namespace filigree::rewriting {
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
