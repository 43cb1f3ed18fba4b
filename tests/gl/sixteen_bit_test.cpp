// 16-bit depth is really allocated, without a stencil. The substitute for the stencil gives the same pictures, stencil
// values and polygon IDs as a real stencil with 24-bit depth. VIEWING_LONG_TESTS=N compares N times as many states.
#include <cstdlib>

#include "gl_test.h"
#include "render/probe.h"
#include "topics/hidden/numbers/hidden_views.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::pixels_beyond;
using testing::scene_named;
using testing::scene_of;
using testing::trials;

constexpr glm::ivec2 coarse_px(128, 72);

GLint bits_of_depth(const View& view) {
    glBindFramebuffer(GL_FRAMEBUFFER, view.target().draw_framebuffer());
    GLint bits = 0;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE,
                                          &bits);
    return bits;
}

/// Returns convex solids that touch neither each other nor the plane, so 16 bits distinguish them as 24 do. The label
/// is in its board's plane, so the stencil, not depth, decides which of the two is visible there. The mirror shows the
/// front of neither.
Scene floating_with_decal() {
    SceneObject label = object("label", quad_mesh(), {1.0, 0.4, -1.7}, {0.35, 1.0, 0.45});
    label.description.decal = true;
    label.description.color = {200, 40, 30};
    return scene_of({label, object("board", quad_mesh(), {0.9, 0.4, -1.8}, {0.7, 1.0, 0.8}),
                     object("box", box_mesh(), {-1.3, 1.1, -0.2}, {0.6, 0.5, 0.7}),
                     object("ball", sphere_mesh(), {1.2, 1.0, 0.6}, glm::dvec3(0.7)),
                     object("high box", box_mesh(), {0.1, 2.6, -1.0}, {0.5, 0.3, 0.4}),
                     object("below", box_mesh(), {-0.4, -1.5, 0.5}, glm::dvec3(0.4))});
}

class SixteenBits : public testing::GlTest {
protected:
    using Choices = std::initializer_list<const char*>;

    std::string one_of(Choices choices) {
        return *(choices.begin() + static_cast<std::ptrdiff_t>(random.number(0, static_cast<double>(choices.size()))));
    }

    /// Returns random settings that use the stencil. Coplanar surfaces must not fight, so the depth test is off if the
    /// shadow has no offset.
    std::vector<std::string> any_use_of_stencil() {
        const std::string offset = one_of({"none", "polygon_offset", "lift", "no_depth_test"});
        const std::string bools[] = {"shadow.enabled",     "shadow.stencil_once", "shadow.clip_to_receiver",
                                     "reflection.enabled", "reflection.stencil",  "shadow.clip_casters"};
        std::vector<std::string> settings{
            "view.samples=0",
            "cull.enabled=true",
            "projection.near=2",
            "projection.far=30",
            "depth.decals=stencil",
            "shadow.lift=0.05",
            "shadow.offset_factor=-1",
            "shadow.offset_units=-4",
            "shadow.offset=" + offset,
            "shadow.style=" + one_of({"blend", "missing_light"}),
            "reflection.clip=" + one_of({"clip_distance", "oblique", "none"}),
            "depth.test=" + (offset == "none" ? std::string("false") : one_of({"true", "true", "false"})),
            "depth.mapping=" + one_of({"standard", "reversed", "logarithmic"}),
            "plane.extent=" + std::to_string(random.number(1.0, 4.0)),
            "projection.type=" + one_of({"perspective", "perspective", "orthographic"}),
            "projection.height=6",
            "visibility.method=" + one_of({"depth_buffer", "depth_buffer", "depth_buffer", "newell", "ray_cast"}),
            "view.shows=" + one_of({"color", "color", "facing", "overdraw"})};
        for (const std::string& name : bools) settings.push_back(name + "=" + one_of({"true", "true", "false"}));
        return settings;
    }

    Params any_params(std::string& what) {
        const std::vector<std::string> settings = any_use_of_stencil();
        for (const std::string& setting : settings) what += " " + setting;
        Params params = params_with(settings);
        params.camera.position = glm::dvec3(random.number(-4, 4), random.number(1.5, 6.0), random.number(6, 9));
        const Angles angles = angles_looking_at(params.camera.position, {0, 0.7, 0});
        params.camera.yaw = angles.yaw_deg;
        params.camera.pitch = angles.pitch_deg;
        return params;
    }

    static FramePlan plan_with(Params params, const char* format, const Scene& scene) {
        params.depth.format = std::string(format) == "d16" ? DepthFormat::d16 : DepthFormat::d24;
        const Derived derived = derive_for(params, scene, coarse_px);
        HiddenPictures pictures;
        if (const auto question = hidden_question(params, derived, coarse_px)) {
            HiddenSurfaceSolver solver(scene);
            pictures = answer_hidden_question(solver, *question).pictures;
        }
        return plan(params, derived, pictures);
    }

    Random random{seed};
};

TEST_F(SixteenBits, AreReallyAllocated) {
    const Scene scene = floating_with_decal();
    const Params plain = params_with({"depth.format=d16", "shadow.enabled=false", "reflection.enabled=false"});
    for (const int samples : {0, 4}) {
        FramePlan frame = plan(plain, derive_for(plain, scene, coarse_px));
        frame.samples = samples;
        View view;
        draw(frame, scene, coarse_px, renderer(), view);
        EXPECT_EQ(bits_of_depth(view), 16);
        GLint found = -1;
        glGetIntegerv(GL_SAMPLES, &found);
        EXPECT_EQ(found, samples);
    }
    for (const char* const format : {"depth.format=d12", "depth.format=d24"}) {
        View view;
        const Params params = params_with({format});
        draw(plan(params, derive_for(params, scene, coarse_px)), scene, coarse_px, renderer(), view);
        EXPECT_EQ(bits_of_depth(view), 24) << format;
    }
}

TEST_F(SixteenBits, DisableSamplesOnlyForTheStencil) {
    const Scene scene = floating_with_decal();
    const auto samples = [&](const std::vector<std::string>& settings) {
        Params params = params_with(settings);
        params.view.samples = 4;
        return plan(params, derive_for(params, scene, coarse_px)).samples;
    };
    const std::string format = "depth.format=d16", no_shadow = "shadow.enabled=false",
                      no_mirror = "reflection.enabled=false";
    EXPECT_EQ(samples({format, no_shadow, no_mirror}), 4);
    EXPECT_EQ(samples({format, no_mirror}), 0);
    EXPECT_EQ(samples({format, no_shadow, "reflection.enabled=true"}), 0);
    EXPECT_EQ(samples({"depth.format=d24", "reflection.enabled=true"}), 4);
}

TEST_F(SixteenBits, WithMasksEqualTheStencil) {
    const Scene scene = floating_with_decal();
    Result<Renderer> limited = Renderer::make({});  // clips by discarding fragments
    ASSERT_TRUE(limited) << limited.error();
    int with_marks = 0, with_label = 0;
    View view_16, view_24, limited_view;  // kept, to show that frames do not depend on earlier ones
    for (int trial = 0; trial < trials(30); ++trial) {
        std::string what = "seed " + std::to_string(seed) + " trial " + std::to_string(trial);
        const Params params = any_params(what);
        SCOPED_TRACE(what);
        FramePlan frame_16 = plan_with(params, "d16", scene), frame_24 = plan_with(params, "d24", scene);
        const Image picture_24 = draw(frame_24, scene, coarse_px, renderer(), view_24);
        EXPECT_TRUE(draw(frame_16, scene, coarse_px, renderer(), view_16) == picture_24);
        EXPECT_FALSE(view_16.target().has_stencil());
        if (trial % 3 == 0 && !frame_16.clip_zero_to_one) {
            const Image discarded = draw(frame_16, scene, coarse_px, *limited, limited_view);
            EXPECT_LE(pixels_beyond(discarded, picture_24, 2), 4);
        }

        FramePlan unlabelled = frame_16;
        std::erase_if(unlabelled.passes, [](const Pass& pass) { return pass.chosen == Chosen::decals; });
        with_label += draw(unlabelled, scene, coarse_px) != picture_24 ? 1 : 0;
        frame_16.shows = frame_24.shows = Shows::stencil;
        const Image stencil = draw(frame_24, scene, coarse_px, renderer(), view_24);
        EXPECT_TRUE(draw(frame_16, scene, coarse_px, renderer(), view_16) == stencil);
        with_marks += stencil != draw(frame_24, scene_of({}), coarse_px) ? 1 : 0;

        ASSERT_TRUE(renderer().draw_identities(frame_24, scene, coarse_px, view_24));
        const Image identities = renderer().read(view_24);
        ASSERT_TRUE(renderer().draw_identities(frame_16, scene, coarse_px, view_16));
        EXPECT_TRUE(renderer().read(view_16) == identities);
    }
    EXPECT_GT(with_marks, trials(30) / 4) << "shadows have to mark pixels";
    EXPECT_GT(with_label, trials(30) / 4) << "and the label has to be visible";
}

TEST_F(SixteenBits, ReportTheMaskAsStencil) {
    const Scene scene = floating_with_decal();
    int marked = 0;
    for (int trial = 0; trial < trials(8); ++trial) {
        std::string what = "seed " + std::to_string(seed) + " trial " + std::to_string(trial);
        const Params params = any_params(what);
        SCOPED_TRACE(what);
        const Derived derived = derive_for(params, scene, coarse_px);
        PixelProbe probe_16, probe_24;
        ASSERT_TRUE(probe_16.prepare(renderer(), plan_with(params, "d16", scene), scene, derived, coarse_px));
        ASSERT_TRUE(probe_24.prepare(renderer(), plan_with(params, "d24", scene), scene, derived, coarse_px));
        for (int pixel = 0; pixel < 200; ++pixel) {
            const glm::ivec2 at(random.number(0, coarse_px.x), random.number(0, coarse_px.y));
            const int stencil = probe_24.at(at, scene).stencil;
            EXPECT_EQ(probe_16.at(at, scene).stencil, stencil) << at.x << " " << at.y;
            marked += stencil > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(marked, 20);
}

TEST_F(SixteenBits, KeepPolygonIdentities) {
    const Scene scene = scene_named("torus-and-boxes");
    const Params params = params_with({"visibility.method=painter", "reflection.enabled=true"});
    View view;
    Result<IdImage> of_24 = renderer().read_polygon_ids(plan_with(params, "d24", scene), scene, coarse_px, view);
    Result<IdImage> of_16 = renderer().read_polygon_ids(plan_with(params, "d16", scene), scene, coarse_px, view);
    ASSERT_TRUE(of_24 && of_16);
    EXPECT_EQ(of_16->ids, of_24->ids);
}

}  // namespace
}  // namespace viewing
