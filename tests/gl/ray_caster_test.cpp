// Compares whole pictures of random planes, lights, cameras and solids with the oracle of ray_caster.h. Each pixel must
// show the right object, patch, shadow or mirror image, except that pixels beside an edge of the oracle's picture are
// skipped. VIEWING_LONG_TESTS=N draws N times as many.
#include "ray_caster.h"

#include <cstdlib>

#include "geometry/shapes.h"
#include "gl_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::OracleCamera;
using testing::OraclePlane;
using testing::OracleScene;
using testing::RayCaster;
using testing::Rgb;
using testing::rgb_at;
using testing::rotation_of;
using testing::scene_of;
using testing::Sight;
using testing::Solid;

constexpr glm::ivec2 cast_px(160, 120);

/// The content of a pixel: 0, 1, 2 … for a solid, or one of these.
constexpr int shows_nothing = -1, shows_patch = -2, shows_shadow = -3, shows_unknown = -9;

/// A random setup for the oracle, and the same setup as parameters and meshes.
struct Situation {
    OracleScene oracle;
    OracleCamera camera;
    Params params;
    Scene scene;

    OraclePlane& plane() { return oracle.planes.front(); }
    const OraclePlane& plane() const { return oracle.planes.front(); }
    glm::dvec4& light() { return oracle.lights.front(); }
};

void add_solids(Situation& made, Random& random) {
    const Color colors[] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    std::vector<SceneObject> objects;
    for (std::size_t i = 0; i < 3; ++i) {
        Solid solid;
        solid.is_sphere = random.number(0, 1) < 0.5;
        solid.position = random.vec3(1.8);
        const Angles angles = random.angles();
        solid.rotation = rotation_of(angles.yaw_deg, angles.pitch_deg, angles.roll_deg);
        const double size = random.number(0.3, 0.8);
        solid.scale =
            solid.is_sphere ? glm::dvec3(size) : glm::dvec3(size, random.number(0.3, 0.8), random.number(0.3, 0.8));
        made.oracle.solids.push_back(solid);
        // The mesh is so fine that its facets deviate from the sphere by well under a pixel.
        SceneObject placed =
            object(std::to_string(i), solid.is_sphere ? sphere_mesh(128, 64) : box_mesh(), solid.position);
        placed.world_from_model = world_from_model(solid.position, angles, solid.scale);
        placed.description.color = colors[i];
        objects.push_back(std::move(placed));
    }
    made.scene = scene_of(std::move(objects));
}

bool is_clear_of_solids(const Situation& made, const glm::dvec3& point, double distance) {
    for (const Solid& solid : made.oracle.solids)
        if (glm::distance(point, solid.position) < glm::length(solid.scale) + distance) return false;
    return true;
}

void add_light(Situation& made, Random& random) {
    const glm::dvec4 plane = made.plane().equation;
    do {
        made.light() = {random.vec3(5.0), random.number(0, 1) < 0.7 ? 1.0 : 0.0};
        const double side = glm::dot(plane, made.light());
        const double eye_side = glm::dot(plane, glm::dvec4(made.camera.position, 1.0));
        if (side * eye_side < 0.0 && random.number(0, 1) < 0.9)  // mostly on the side where shadows are visible
            made.light() -= 2.0 * side * glm::dvec4(glm::dvec3(plane), 0.0);
    } while (std::abs(glm::dot(plane, made.light())) < 0.3 ||
             (made.light().w > 0.0 && !is_clear_of_solids(made, glm::dvec3(made.light()), 0.1)));
}

Situation situation(unsigned number) {
    Random random(number);
    Situation made;
    add_solids(made, random);
    made.oracle.planes = {{.equation = {random.direction(), random.number(-1.2, 1.2)}}};
    made.plane().extent = random.number(2.0, 5.0);
    made.oracle.lights.resize(1);

    OracleCamera& camera = made.camera;
    do camera.position = random.direction() * random.number(4.5, 8.0);
    while (std::abs(glm::dot(made.plane().equation, glm::dvec4(camera.position, 1.0))) < 0.8 ||
           !is_clear_of_solids(made, camera.position, 0.5));
    const Angles angles = angles_looking_at(camera.position, random.vec3(1.0));
    camera.yaw_deg = angles.yaw_deg;
    camera.pitch_deg = angles.pitch_deg;
    camera.roll_deg = random.number(-180, 180);
    camera.orthographic = number % 4 == 3;
    camera.fovy_deg = random.number(30, 75);
    camera.height = random.number(3, 7);
    add_light(made, random);
    made.oracle.casts = number % 3 != 1;
    made.plane().mirrors = number % 3 != 0;

    Params& params = made.params;
    params.camera.position = camera.position;
    params.camera.yaw = camera.yaw_deg;
    params.camera.pitch = camera.pitch_deg;
    params.camera.roll = camera.roll_deg;
    params.projection = {camera.orthographic ? ProjectionType::orthographic : ProjectionType::perspective,
                         camera.fovy_deg, camera.height, camera.near, camera.far};
    params.planes.front() = {made.plane().equation * (random.number(0, 1) < 0.5 ? -1.0 : 1.0) * random.number(0.3, 3.0),
                             made.plane().extent};
    params.lights.front().position = made.light();
    params.shadow.enabled = made.oracle.casts;
    params.shadow.color = {255, 0, 255};
    params.shadow.opacity = 1.0;
    params.shadow.stencil_once = random.number(0, 1) < 0.5;
    params.shadow.offset = number % 5 == 4 ? ShadowOffset::no_depth_test : ShadowOffset::polygon_offset;
    params.reflection.enabled = made.plane().mirrors;
    params.reflection.reflectance = 1.0;
    params.reflection.clip = number % 2 == 0 ? MirrorClip::clip_distance : MirrorClip::oblique;
    params.depth.mapping = static_cast<DepthMapping>(number % 7 % 3);
    params.depth.format = number % 6 == 5 ? DepthFormat::d32f : DepthFormat::d24;
    params.cull.enabled = random.number(0, 1) < 0.5;
    params.view.samples = 0;
    return made;
}

/// Decodes a pixel's color: objects are pure red, green and blue, the patch gray, the shadow magenta.
int class_seen(const Rgb& color, const Rgb& background) {
    if (color == background) return shows_nothing;
    if (color == Rgb(255, 0, 255)) return shows_shadow;
    const int largest = std::max({color.r, color.g, color.b}), smallest = std::min({color.r, color.g, color.b});
    if (largest - smallest <= 3) return shows_patch;
    for (int channel = 0; channel < 3; ++channel)
        if (color[channel] == largest && color[(channel + 1) % 3] < largest && color[(channel + 2) % 3] < largest)
            return channel;
    return shows_unknown;
}

/// Returns the class that the oracle expects. Shadows are painted on mirrors, too.
int class_seen(const Sight& sight) {
    for (const testing::Met& met : sight.met)
        if (met.missing != 0) return shows_shadow;
    if (sight.ends_in_background()) return shows_nothing;
    return sight.met.back().patch >= 0 ? shows_patch : sight.met.back().solid;
}

std::vector<int> classes_by_rays(const Situation& made) {
    const RayCaster caster(made.oracle, made.camera);
    std::vector<int> classes;
    for (int y = 0; y < cast_px.y; ++y)
        for (int x = 0; x < cast_px.x; ++x)
            classes.push_back(class_seen(caster.at(x + 0.5, y + 0.5, cast_px.x, cast_px.y)));
    return classes;
}

struct CastTally {
    int compared = 0, wrong = 0, shadow = 0, patch = 0, objects = 0;
    std::string first_wrong;
};

/// Compares the pixels that have the same class as all their neighbors in the oracle's picture.
CastTally compare(const Image& image, const std::vector<int>& expected, const Rgb& background) {
    const auto expected_at = [&](int x, int y) { return expected[static_cast<std::size_t>(y * cast_px.x + x)]; };
    CastTally tally;
    for (int y = 1; y + 1 < cast_px.y; ++y) {
        for (int x = 1; x + 1 < cast_px.x; ++x) {
            const int here = expected_at(x, y);
            bool is_edge = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) is_edge = is_edge || expected_at(x + dx, y + dy) != here;
            if (is_edge) continue;
            ++tally.compared;
            tally.shadow += here == shows_shadow;
            tally.patch += here == shows_patch;
            tally.objects += here >= 0;
            const int found = class_seen(rgb_at(image, {x, y}), background);
            if (found == here) continue;
            if (tally.wrong++ == 0)
                tally.first_wrong = "at " + std::to_string(x) + "," + std::to_string(y) + " " + std::to_string(found) +
                                    " in place of " + std::to_string(here);
        }
    }
    return tally;
}

class RayCasterTest : public testing::GlTest {
protected:
    static CastTally tally_of(const Situation& made) {
        FramePlan frame = plan(made.params, derive_for(made.params, made.scene, cast_px));
        frame.patch_light = frame.patch_dark = frame.patch_line = {190, 190, 190};
        const Rgb background(frame.background.r, frame.background.g, frame.background.b);
        return compare(draw(frame, made.scene, cast_px), classes_by_rays(made), background);
    }
};

TEST_F(RayCasterTest, AgreesWithEveryPicture) {
    const auto count = static_cast<unsigned>(testing::trials(120));
    constexpr unsigned first_seed = 52000;
    CastTally sum;
    int mirrored = 0;
    for (unsigned number = first_seed; number < first_seed + count; ++number) {
        const Situation made = situation(number);
        const CastTally tally = tally_of(made);
        // A rasterizer may leave a pinhole where it clips a triangle. One compiler's scenes had 4 such pixels in 43
        // million; the other compiler's scenes, which differ in their last bits, had 2 in 2 million.
        EXPECT_LE(tally.wrong, 1) << "seed " << number << ": " << tally.first_wrong;
        sum.wrong += tally.wrong;
        EXPECT_GT(tally.compared, cast_px.x * cast_px.y / 2) << "seed " << number;
        sum.compared += tally.compared;
        sum.shadow += tally.shadow;
        sum.patch += tally.patch;
        if (made.plane().mirrors) {
            Situation blind = made;
            blind.plane().mirrors = false;
            const std::vector<int> with = classes_by_rays(made), without = classes_by_rays(blind);
            for (std::size_t i = 0; i < with.size(); ++i) mirrored += with[i] >= 0 && with[i] != without[i];
        }
    }
    EXPECT_LE(sum.wrong, 3 + sum.compared / 5'000'000);
    // Each kind of pixel must have occurred often enough for the comparison to mean something.
    const auto each = static_cast<int>(count);
    std::printf("%d pixels, %d wrong: %d shadow, %d patch, %d mirror image\n", sum.compared, sum.wrong, sum.shadow,
                sum.patch, mirrored);
    EXPECT_GT(sum.shadow, 150 * each);
    EXPECT_GT(sum.patch, 500 * each);
    EXPECT_GT(mirrored, 150 * each);
}

TEST_F(RayCasterTest, DetectsWrongMatrices) {
    // When pictures use other matrices instead of S and R, the oracle must disagree with them.
    Situation made = situation(52002);
    ASSERT_TRUE(made.oracle.casts);
    ASSERT_EQ(tally_of(made).wrong, 0);
    Derived derived = derive_for(made.params, made.scene, cast_px);
    glm::dmat4 shifted = derived.planes[0].shadows[0].shadowed_world_from_world;
    shifted[3] += glm::dvec4(0.2, 0.0, 0.2, 0.0) * derived.planes[0].shadows[0].sign;
    made.params.overrides[0].shadowed_world_from_world[0] = shifted;
    EXPECT_GT(tally_of(made).wrong, 0);

    Situation mirror = situation(52000);
    ASSERT_TRUE(mirror.plane().mirrors);
    ASSERT_EQ(tally_of(mirror).wrong, 0);
    derived = derive_for(mirror.params, mirror.scene, cast_px);
    mirror.params.overrides[0].mirrored_world_from_world =
        glm::translate(derived.planes[0].mirrored_world_from_world, {0.3, 0.3, 0.3});
    EXPECT_GT(tally_of(mirror).wrong, 0);
}

}  // namespace
}  // namespace viewing
