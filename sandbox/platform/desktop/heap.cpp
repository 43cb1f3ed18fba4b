#include "platform/heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace viewing {
namespace {

constexpr int heap_bytes = 32 << 20;
constexpr std::uintptr_t large_page_bytes = 2 << 20;

std::uintptr_t end_of_heap() {
    return reinterpret_cast<std::uintptr_t>(sbrk(0));
}

/// Until the heap grows, by `heap_bytes` at once. A block that is taken from elsewhere ends the search.
void grow_heap() {
    constexpr std::size_t block_bytes = 64 << 10;
    constexpr int most_blocks = 8;  // what is free in a heap at a program's beginning is less
    const std::uintptr_t before = end_of_heap();
    mallopt(M_TOP_PAD, heap_bytes);
    void* volatile blocks[most_blocks] = {};  // volatile: a compiler may leave out what is freed unused
    for (void* volatile& block : blocks)
        if (block = std::malloc(block_bytes); end_of_heap() != before) break;
    for (void* block : blocks) std::free(block);
    constexpr int usual_pad_bytes = 128 << 10;
    mallopt(M_TOP_PAD, usual_pad_bytes);
}

}  // namespace

void prefer_large_pages() {
    mallopt(M_MMAP_THRESHOLD, heap_bytes);
    mallopt(M_TRIM_THRESHOLD, 2 * heap_bytes);
    const std::uintptr_t first = end_of_heap();
    grow_heap();
    const std::uintptr_t from = (first + large_page_bytes - 1) / large_page_bytes * large_page_bytes;
    const std::uintptr_t to = end_of_heap();
    if (to > from) madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);
}

}  // namespace viewing
