// Reads back blocks of pixels and whole buffers: blocks equal single reads, values are the same with and without GL's
// ability to read depth and stencil, and counts match the depths.
#include "render/buffer_read.h"

#include <cmath>
#include <numeric>

#include "gl_test.h"
#include "render/probe.h"

namespace viewing {
namespace {

using testing::params_with;
using testing::scene_named;
using testing::setting;

constexpr glm::ivec2 read_px(160, 90);
const char* const formats[] = {"d4", "d8", "d12", "d16", "d24", "d32f"};
const char* const mappings[] = {"standard", "reversed", "logarithmic"};

class BufferRead : public testing::GlTest {
protected:
    static PixelProbe probe_of(const Params& params, const Scene& scene, Renderer& with = renderer()) {
        const Derived derived = derive(params, scene, {read_px, with.capabilities().clip_control});
        PixelProbe probe;
        const Status prepared = probe.prepare(with, plan(params, derived), scene, derived, read_px);
        EXPECT_TRUE(prepared) << prepared.error();
        return probe;
    }

    /// Returns a renderer that lacks the ability to read depth and stencil.
    static Renderer without_reading() {
        gl::Capabilities capabilities = renderer().capabilities();
        EXPECT_TRUE(capabilities.read_depth_stencil);
        capabilities.read_depth_stencil = false;
        Result<Renderer> made = Renderer::make(capabilities);
        EXPECT_TRUE(made) << made.error();
        return *std::move(made);
    }
};

TEST_F(BufferRead, BlocksEqualSingleReads) {
    const Scene scene = scene_named("torus-and-boxes");
    for (const char* const format : formats) {
        const PixelProbe probe = probe_of(params_with({setting("depth.format", format)}), scene);
        const CellBlock block = probe.block({70, 35}, {13, 9});
        ASSERT_EQ(block.size, glm::ivec2(13, 9));
        ASSERT_EQ(block.cells.size(), 13U * 9U);
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 13; ++x) {
                const PixelReport report = probe.at({70 + x, 35 + y}, scene);
                EXPECT_EQ(block.at({x, y}), (BufferCell{report.color, report.stored, report.window_depth}))
                    << format << " " << x << ", " << y;
            }
    }
}

TEST_F(BufferRead, BlocksEndAtThePicturesEdge) {
    const Scene scene = scene_named("torus-and-boxes");
    const PixelProbe probe = probe_of(Params{}, scene);
    const auto block = [&](glm::ivec2 first, glm::ivec2 size) {
        const CellBlock found = probe.block(first, size);
        EXPECT_EQ(found.cells.size(), static_cast<std::size_t>(found.size.x * found.size.y));
        return glm::ivec4(found.first_pixel, found.size);
    };
    EXPECT_EQ(block({-3, -2}, {8, 8}), glm::ivec4(0, 0, 5, 6));
    EXPECT_EQ(block({155, 80}, {20, 20}), glm::ivec4(155, 80, 5, 10));
    EXPECT_EQ(block({0, 0}, {1000, 1000}), glm::ivec4(0, 0, 160, 90));
    for (const glm::ivec4 outside : {glm::ivec4(160, 0, 4, 4), glm::ivec4(0, 90, 4, 4), glm::ivec4(-9, -9, 4, 4),
                                     glm::ivec4(5, 5, 0, 3), glm::ivec4(5, 5, -2, 3)})
        EXPECT_TRUE(probe.block({outside.x, outside.y}, {outside.z, outside.w}).cells.empty());
    EXPECT_TRUE(PixelProbe().block({0, 0}, {4, 4}).cells.empty());
}

TEST_F(BufferRead, IsTheSameWithoutReadingDepthAndStencil) {
    Renderer without = without_reading();
    const Scene scene = scene_named("torus-and-boxes");
    for (const char* const mapping : mappings)
        for (const char* const format : formats) {
            const Params params = params_with({setting("depth.format", format), setting("depth.mapping", mapping)});
            const PixelProbe read = probe_of(params, scene), drawn = probe_of(params, scene, without);
            const CellBlock expected = read.block({0, 0}, read_px), found = drawn.block({0, 0}, read_px);
            const std::uint32_t allowed = std::string(format) == "d24" ? 1 : 0;
            for (std::size_t i = 0; i < expected.cells.size(); ++i) {
                EXPECT_EQ(found.cells[i].color, expected.cells[i].color);
                const std::uint32_t a = found.cells[i].stored, b = expected.cells[i].stored;
                ASSERT_LE(a < b ? b - a : a - b, allowed) << mapping << " " << format << " cell " << i;
            }
            for (const glm::ivec2 pixel : {glm::ivec2(3, 4), glm::ivec2(80, 45), glm::ivec2(70, 80), glm::ivec2(20, 60),
                                           glm::ivec2(100, 70), glm::ivec2(130, 62)}) {
                const PixelReport a = read.at(pixel, scene), b = drawn.at(pixel, scene);
                EXPECT_EQ(a.stencil, b.stencil) << pixel.x << ", " << pixel.y;
                EXPECT_EQ(a.object, b.object);
                EXPECT_EQ(a.color, b.color);
                EXPECT_NEAR(a.eye_z, b.eye_z, 2.0 * a.step);
            }
            const DepthCounts a = read.count_depths(), b = drawn.count_depths();
            EXPECT_EQ(a.unwritten, b.unwritten);
            std::uint32_t moved = 0;
            for (std::size_t bin = 0; bin < a.counts.size(); ++bin)
                moved += a.counts[bin] > b.counts[bin] ? a.counts[bin] - b.counts[bin] : 0;
            EXPECT_LE(moved, allowed * 20) << mapping << " " << format;
        }
}

TEST_F(BufferRead, StencilIsReadByItsBits) {
    // One renderer reads the stencil with GL; the other gathers it bit by bit. Both find the marks from 0 to 255, which
    // are drawn side by side.
    Renderer without = without_reading();
    Scene scene = testing::scene_of({});
    for (int i = 0; i < 16; ++i) {
        SceneObject quad = testing::object("quad", quad_mesh(), {0, 0, 0});
        quad.world_from_model = world_from_model({i * 0.5 - 3.75, 0, -10}, {0, 90, 0}, glm::dvec3(0.25, 0.25, 8));
        scene.objects.push_back(quad);
    }
    const Params params = params_with({"camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0",
                                       "shadow.enabled=false", "reflection.enabled=false", "plane.extent=0.001",
                                       "plane.equation=[0,1,0,1000000]", "projection.fovy=40"});
    const Derived derived = derive_for(params, scene, read_px);
    FramePlan frame = plan(params, derived);
    frame.passes.back().marks_objects = true;
    frame.passes.back().stencil = {true, CompareFunc::always, 0, StencilOp::replace};
    for (int i = 0; i < 16; ++i) frame.object_marks.push_back(i * 17);
    for (const DepthFormat format : {DepthFormat::d24, DepthFormat::d32f, DepthFormat::d16}) {
        frame.depth_format = format;
        for (Renderer* const with : {&renderer(), &without}) {
            PixelProbe probe;
            ASSERT_TRUE(probe.prepare(*with, frame, scene, derived, read_px));
            for (int i = 0; i < 16; ++i) {
                const glm::dvec3 point(i * 0.5 - 3.75, 0.3, -10);
                EXPECT_EQ(probe.at(testing::pixel_of(point, derived, read_px), scene).stencil, i * 17)
                    << "format " << static_cast<int>(format);
            }
        }
    }
}

TEST_F(BufferRead, WorksWithOnlyTheCommonSubset) {
    Result<Renderer> plain = Renderer::make({});
    ASSERT_TRUE(plain) << plain.error();
    const Scene scene = scene_named("torus-and-boxes");
    for (const char* const format : formats) {
        const PixelProbe probe =
            probe_of(params_with({setting("depth.format", format), "depth.mapping=reversed"}), scene, *plain);
        const PixelReport report = probe.at({80, 45}, scene);
        EXPECT_TRUE(report.written);
        EXPECT_LT(report.eye_z, -1.0) << format;
        EXPECT_GT(report.eye_z, -40.0) << format;
        EXPECT_EQ(probe.block({0, 0}, read_px).cells.size(), 160U * 90U);
        const DepthCounts counts = probe.count_depths();
        EXPECT_EQ(std::accumulate(counts.counts.begin(), counts.counts.end(), counts.unwritten), 160U * 90U);
    }
}

TEST_F(BufferRead, CountsMatchTheBlocks) {
    const Scene scene = scene_named("torus-and-boxes");
    for (const char* const scale : {"linear", "window"})
        for (const char* const mapping : mappings)
            for (const char* const format : formats) {
                const Params params = params_with({setting("depth.format", format), setting("depth.mapping", mapping),
                                                   setting("view.depth_scale", scale)});
                const PixelProbe probe = probe_of(params, scene);
                const DepthCounts counts = probe.count_depths();
                const double cleared = std::string(mapping) == "reversed" ? 0.0 : 1.0;
                std::vector<int> expected(counts.counts.size(), 0);
                std::uint64_t unwritten = 0;
                for (const BufferCell& cell : probe.block({0, 0}, read_px).cells) {
                    if (cell.window_depth == cleared) {
                        ++unwritten;
                        continue;
                    }
                    const double value =
                        std::string(scale) == "window"
                            ? cell.window_depth
                            : (distance_of_window_depth(params.lens(), params.depth.mapping, cell.window_depth) -
                               params.projection.near) /
                                  (params.projection.far - params.projection.near);
                    ++expected[static_cast<std::size_t>(std::clamp(value * 128.0, 0.0, 127.0))];
                }
                EXPECT_EQ(counts.unwritten, unwritten);
                // Float32 rounding may move a depth at a bin's edge into the next bin; with few bits, many pixels share
                // that depth.
                int moved = 0;
                for (std::size_t bin = 0; bin < expected.size(); ++bin)
                    moved += std::max(expected[bin] - static_cast<int>(counts.counts[bin]), 0);
                EXPECT_LE(moved, 20) << scale << " " << mapping << " " << format;
            }
}

TEST_F(BufferRead, MultisampledViewsAreNotCounted) {
    const Scene scene = scene_named("torus-and-boxes");
    const Params params = params_with({"view.samples=4"});
    const FramePlan frame = plan(params, derive_for(params, scene, read_px));
    View view;
    draw(frame, scene, read_px, renderer(), view);
    Result<BufferReader> reader = BufferReader::make(renderer().capabilities());
    ASSERT_TRUE(reader);
    const DepthCounts counts = reader->count_depths(view, frame);
    EXPECT_EQ(std::accumulate(counts.counts.begin(), counts.counts.end(), counts.unwritten), 0U);
}

}  // namespace
}  // namespace viewing
