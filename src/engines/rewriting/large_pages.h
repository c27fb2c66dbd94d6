// Large pages for large words: the kernel gives them only to who asks, and memory that is used for the first time is
// then written two to three times as fast.
#pragma once

#include <cstddef>

namespace filigree::rewriting {

// A wish: where it is refused, all goes on as it is.
void ask_for_large_pages(void* bytes, std::size_t size);

}  // namespace filigree::rewriting
