// The heap's reserve and large pages. The tests check where the heap is and that a shortage of memory loses nothing.
// Each test runs in a child process, because a process keeps its heap and sets up the reserve at startup.
#include "platform/heap.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace viewing {
namespace {

std::uintptr_t end_of_heap() {
    return reinterpret_cast<std::uintptr_t>(::sbrk(0));
}

/// Returns false under a sanitizer, which has its own heap elsewhere.
bool has_the_librarys_heap() {
    void* volatile block = std::malloc(64);
    const bool is_inside = reinterpret_cast<std::uintptr_t>(block) < end_of_heap();
    std::free(block);
    return is_inside;
}

/// Returns a line of /proc/self/smaps, such as "Rss" or "VmFlags", for the mapping that contains the address.
std::string mapping_line(std::uintptr_t address, const std::string& name) {
    std::ifstream mappings("/proc/self/smaps");
    bool is_inside = false;
    for (std::string line; std::getline(mappings, line);) {
        std::uintptr_t from = 0, to = 0;
        char dash = 0;
        if (std::istringstream head(line); head >> std::hex >> from >> dash >> to && dash == '-')
            is_inside = from <= address && address < to;
        else if (is_inside && line.rfind(name + ":", 0) == 0)
            return line.substr(name.size() + 1) + " ";
    }
    return "";
}

int status_of_child(int (*run)()) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(run());
    int state = 0;
    if (::waitpid(child, &state, 0) != child) return -2;
    return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
}

int reserved_untouched() {
    const std::uintptr_t before = end_of_heap();
    reserve_heap();
    const std::uintptr_t after = end_of_heap();
    if (after - before < 31U << 20) return 1;
    return std::stoi(mapping_line(after - 1, "Rss")) > 6144 ? 2 : 0;
}

int taken_while_quick() {
    reserve_heap();
    take_large_pages(std::chrono::hours(1));
    // The last page may be incomplete.
    return mapping_line(end_of_heap() - (3U << 20), "VmFlags").find(" hg ") == std::string::npos ? 1 : 0;
}

int ended_by_a_slow_one() {
    reserve_heap();
    const std::uintptr_t end = end_of_heap();
    take_large_pages(std::chrono::microseconds(0));
    if (mapping_line(end - (3U << 20), "VmFlags").find(" hg ") != std::string::npos) return 1;
    for (std::uintptr_t page = end - (32U << 20); page < end; page += 1U << 20)
        if (mapping_line(page, "VmFlags").find(" hg ") != std::string::npos) return 0;
    return 2;  // no large page was requested
}

int blocks_from_it() {
    reserve_heap();
    void* block = std::malloc(4 << 20);
    const bool is_inside = reinterpret_cast<std::uintptr_t>(block) < end_of_heap();
    std::free(block);
    return is_inside ? 0 : 1;
}

int memory_where_it_may_not_grow() {
    const rlimit limit{16U << 20, 16U << 20};
    if (::setrlimit(RLIMIT_DATA, &limit) != 0) return 1;
    const std::uintptr_t before = end_of_heap();
    reserve_heap();
    if (end_of_heap() - before > 16U << 20) return 2;
    void* block = std::malloc(1 << 20);
    const bool is_there = block != nullptr;
    std::free(block);
    return is_there ? 0 : 3;
}

/// These are measured before any other test uses up memory, because malloc may switch to another arena after that.
struct Found {
    bool has_heap = has_the_librarys_heap();
    int reserved = status_of_child(reserved_untouched), taken = status_of_child(taken_while_quick),
        ended = status_of_child(ended_by_a_slow_one), blocks = status_of_child(blocks_from_it),
        limited = status_of_child(memory_where_it_may_not_grow);
};
const Found found;

TEST(Heap, IsReservedAtStartupButNotTouched) {
    if (!found.has_heap) GTEST_SKIP();
    EXPECT_EQ(found.reserved, 0);
}

TEST(Heap, UsesLargePagesUntilOneIsSlow) {
    if (!found.has_heap || !std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) GTEST_SKIP();
    EXPECT_EQ(found.taken, 0);
    EXPECT_EQ(found.ended, 0);
}

TEST(Heap, HoldsTheBlocksOfAPicture) {
    if (!found.has_heap) GTEST_SKIP();
    EXPECT_EQ(found.blocks, 0);
}

TEST(Heap, FallsBackWhenItCannotGrow) {
    if (!found.has_heap) GTEST_SKIP();
    EXPECT_EQ(found.limited, 0);
}

}  // namespace
}  // namespace viewing
