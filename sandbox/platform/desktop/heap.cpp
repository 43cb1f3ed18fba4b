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

/// Allocates blocks until the heap grows by `heap_bytes` in one step, then frees the blocks. Stops after a few blocks
/// if the heap does not grow.
void grow_heap() {
    constexpr std::size_t block_bytes = 64 << 10;
    constexpr int most_blocks = 8;  // at program start, the free space in the heap is less than this
    const std::uintptr_t before = end_of_heap();
    mallopt(M_TOP_PAD, heap_bytes);
    void* volatile blocks[most_blocks] = {};  // volatile: otherwise a compiler may omit unused blocks
    for (void* volatile& block : blocks)
        if (block = std::malloc(block_bytes); end_of_heap() != before) break;
    for (void* block : blocks) std::free(block);
    constexpr int usual_pad_bytes = 128 << 10;
    mallopt(M_TOP_PAD, usual_pad_bytes);
}

std::uintptr_t reserve_begin = 0, reserve_end = 0;

}  // namespace

void reserve_heap() {
    mallopt(M_MMAP_THRESHOLD, heap_bytes);
    mallopt(M_TRIM_THRESHOLD, 2 * heap_bytes);
    reserve_begin = end_of_heap();
    grow_heap();
    reserve_end = end_of_heap();
}

void give_large_blocks_back() {
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
}

void take_large_pages(std::chrono::microseconds longest) {
    using Clock = std::chrono::steady_clock;
    std::uintptr_t at = (reserve_begin + large_page_bytes - 1) / large_page_bytes * large_page_bytes;
    reserve_begin = reserve_end;  // request each page only once
    for (; at + large_page_bytes <= reserve_end; at += large_page_bytes) {
        void* const page = reinterpret_cast<void*>(at);
        const Clock::time_point begin = Clock::now();
        const bool is_taken = madvise(page, large_page_bytes, MADV_HUGEPAGE) == 0 &&
                              madvise(page, large_page_bytes, MADV_POPULATE_WRITE) == 0;
        if (!is_taken || Clock::now() - begin > longest) return;
    }
}

}  // namespace viewing
