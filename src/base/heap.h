// The program's heap, set up for many large short-lived arrays.
#pragma once

namespace filigree {

// Once, first thing in main: what is freed stays with the process, and what is new comes in large pages, so that the
// kernel is asked for memory hundreds of times and not tens of thousands. Uses no memory by itself; does nothing where
// the C library is not glibc.
void prepare_heap();

}  // namespace filigree
