// The methods' cost on many objects: memory in proportion to the polygons, and a quick end after cancellation.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <numeric>

#include "geometry/shapes.h"
#include "scenes.h"
#include "topics/hidden/methods/culling.h"
#include "topics/hidden/methods/newell.h"
#include "topics/hidden/methods/painter.h"

namespace {

std::atomic<std::size_t> allocated_bytes{0};

}  // namespace

// Not inlined, so that the compiler can match each new with its delete.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
    allocated_bytes += bytes;
    if (void* const memory = std::malloc(bytes)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    allocated_bytes += bytes;
    return std::malloc(bytes);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace viewing {
namespace {

std::size_t bytes_for(int boxes) {
    const Mesh box = box_mesh();
    const std::vector<MeshInstance> instances(static_cast<std::size_t>(boxes), MeshInstance{&box});
    const std::size_t before = allocated_bytes;
    EXPECT_EQ(polygons_of(instances).polygons.size(), 12U * static_cast<std::size_t>(boxes));
    return allocated_bytes - before;
}

TEST(Cost, OfManyObjectsIsProportionalToTheirPolygons) {
    const auto few = static_cast<double>(bytes_for(500)), many = static_cast<double>(bytes_for(4000));
    EXPECT_LT(many / few, 8.5) << "eight times the polygons";
}

std::vector<Polygon> boxes_in_a_row(int count) {
    const Mesh box = box_mesh();
    std::vector<MeshInstance> instances;
    for (int i = 0; i < count; ++i) instances.push_back({&box, world_from_model({3.0 * i, 0, 0}, {}, glm::dvec3(1.0))});
    return polygons_of(instances).polygons;
}

TEST(Cost, CanceledPainterStopsSorting) {
    const std::vector<Polygon> polygons = boxes_in_a_row(1000);
    WorkProgress progress;
    progress.canceled = true;
    const PainterOrder whole = painter_order(polygons, viewpoint_on_z(), PainterKey::farthest);
    PainterOrder cut = painter_order(polygons, viewpoint_on_z(), PainterKey::farthest, &progress);
    EXPECT_LT(cut.comparisons, 3 * static_cast<std::int64_t>(polygons.size())) << "only the heap is built";
    EXPECT_GT(whole.comparisons, 10 * static_cast<std::int64_t>(polygons.size()));
    std::sort(cut.order.begin(), cut.order.end());
    std::vector<int> each(polygons.size());
    std::iota(each.begin(), each.end(), 0);
    EXPECT_EQ(cut.order, each) << "every polygon is still drawn";
}

TEST(Cost, CanceledNewellComparesNothing) {
    WorkProgress progress;
    progress.canceled = true;
    const NewellOrder cut = newell_order(boxes_in_a_row(1000), viewpoint_on_z(), {}, &progress);
    EXPECT_EQ(cut.counters.pairs, 0);
    EXPECT_FALSE(cut.problem.empty());
}

/// Cancellation must also stop the per-polygon work before and around the methods, for any number of polygons.
TEST(Cost, CanceledBeforeItStartsSkipsAllPerPolygonWork) {
    const Mesh box = box_mesh();
    const std::vector<MeshInstance> instances(4000, MeshInstance{&box});
    const std::vector<Polygon> polygons = polygons_of(instances).polygons;
    ASSERT_GT(polygons.size(), 32'768U) << "fewer polygons are processed in one go";
    WorkProgress progress;
    progress.canceled = true;
    EXPECT_TRUE(polygons_of(instances, &progress).polygons.empty());
    EXPECT_EQ(count_facing(polygons, viewpoint_on_z(), FrontFace::ccw, &progress).input, 0);
    const auto left = [&](std::span<const Polygon> of, const WorkProgress* watched) {
        return culled(of, viewpoint_on_z(), CullFace::front, FrontFace::ccw, watched).size();
    };
    EXPECT_EQ(left(polygons, &progress), left(std::span(polygons).first(32'768), nullptr));
    EXPECT_LT(left(polygons, &progress), left(polygons, nullptr));

    const std::size_t before = allocated_bytes;
    const NewellOrder cut = newell_order(polygons, viewpoint_on_z(), {}, &progress);
    EXPECT_EQ(say(cut.problem), "Newell's sort was canceled before it began: nothing is drawn.");
    EXPECT_TRUE(cut.order.empty());
    const std::size_t of_cut = allocated_bytes - before;
    newell_order(polygons, viewpoint_on_z(), {.max_pairs = 1});
    EXPECT_LT(of_cut, (allocated_bytes - before - of_cut) * 9 / 10);
}

}  // namespace
}  // namespace viewing
