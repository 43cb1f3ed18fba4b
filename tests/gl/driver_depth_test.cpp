// The properties of the driver's depth, which the program measures by drawing, agree with values read back: the codes
// that a clear stores, and the number of codes by which an offset moves a square.
#include <bit>
#include <cmath>
#include <set>

#include "gl_test.h"
#include "render/probe.h"
#include "render/stored_depth.h"

namespace viewing {
namespace {

using testing::object;
using testing::scene_of;

class DriverDepthTest : public testing::GlTest {
protected:
    static StoredDepth measured(gl::DepthKind kind) {
        const Result<StoredDepth> stored = measure_stored_depth(renderer().capabilities(), kind);
        if (!stored) throw std::runtime_error(stored.error());
        return *stored;
    }

    /// Returns the number of distinct codes among 64 clear depths, starting at `first`.
    static std::size_t kept_apart(gl::DepthKind kind, double first, double step) {
        const gl::Target target({{1, 1}, 0, kind});
        std::set<float> stored;
        for (int i = 0; i < 64; ++i) {
            glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
            glDepthMask(GL_TRUE);
            glClearDepth(first + i * step);
            glClear(GL_DEPTH_BUFFER_BIT);
            float depth = 0.0F;
            glReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
            stored.insert(depth);
        }
        glClearDepth(1.0);
        return stored.size();
    }

    static PixelReport square(DepthFormat format, double units) {
        Params params =
            testing::params_with({"camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0", "shadow.enabled=false",
                                  "reflection.enabled=false", "plane.equation=[0,1,0,1000000]", "plane.extent=0.001",
                                  "projection.type=orthographic", "projection.near=1", "projection.far=5"});
        params.depth.format = format;
        params.depth.offset = {0.0, units};
        SceneObject quad = object("quad", quad_mesh(), {0, 0, 0});
        quad.description.decal = true;
        quad.world_from_model = world_from_model({0, 0, -4}, {0, 90, 0}, glm::dvec3(20.0));
        const Scene scene = scene_of({quad});
        constexpr glm::ivec2 size_px(8, 8);
        const Derived derived = derive_for(params, scene, size_px);
        PixelProbe probe;
        EXPECT_TRUE(probe.prepare(renderer(), plan(params, derived), scene, derived, size_px));
        return probe.at(size_px / 2, scene);
    }
};

TEST_F(DriverDepthTest, StoresAsManyCodesAsAreReadBack) {
    for (const gl::DepthKind kind : {gl::DepthKind::d16, gl::DepthKind::d24_s8, gl::DepthKind::d32f_s8}) {
        SCOPED_TRACE(static_cast<int>(kind));
        const StoredDepth stored = measured(kind);
        const int bits = std::min(stored.precision.bits, 24);
        // 64 depths one code apart are stored as 64 codes; 64 depths half a code apart, as 32 or 33. Below 1/2, a
        // float's codes are half as wide.
        EXPECT_NEAR(static_cast<double>(kept_apart(kind, 0.75, std::exp2(-bits))), 64.0, 1.0);
        if (bits < 24) {
            EXPECT_LE(kept_apart(kind, 0.75, std::exp2(-bits - 1)), 34U);
        }
        EXPECT_EQ(stored.precision.is_float, kept_apart(kind, 0.375, std::exp2(-25)) > 48U);
    }
}

TEST_F(DriverDepthTest, AnOffsetUnitMovesASquareByTheMeasuredCodes) {
    for (const auto& [format, kind] :
         {std::pair{DepthFormat::d16, gl::DepthKind::d16}, std::pair{DepthFormat::d24, gl::DepthKind::d24_s8},
          std::pair{DepthFormat::d32f, gl::DepthKind::d32f_s8}}) {
        SCOPED_TRACE(static_cast<int>(format));
        const StoredDepth stored = measured(kind);
        const PixelReport still = square(format, 0.0), moved = square(format, 8.0);
        EXPECT_NEAR(still.window_depth, 0.75, 1e-4);
        EXPECT_EQ(static_cast<double>(moved.stored) - still.stored, 8.0 * *stored.unit_codes);
    }
}

/// Measuring may happen between two pictures, so it must not change GL's state.
TEST_F(DriverDepthTest, LeavesNoTrace) {
    const PixelReport before = square(DepthFormat::d24, 1.0);
    const StoredDepth first = measured(gl::DepthKind::d24_s8), second = measured(gl::DepthKind::d24_s8);
    EXPECT_FALSE(glIsEnabled(GL_DEPTH_TEST));
    EXPECT_FALSE(glIsEnabled(GL_POLYGON_OFFSET_FILL));
    EXPECT_EQ(first, second);
    EXPECT_EQ(square(DepthFormat::d24, 1.0).stored, before.stored);
    GLboolean writes = GL_FALSE;
    glGetBooleanv(GL_DEPTH_WRITEMASK, &writes);
    EXPECT_TRUE(writes);
}

}  // namespace
}  // namespace viewing
