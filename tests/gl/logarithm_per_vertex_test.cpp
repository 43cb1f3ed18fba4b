// Compares the per-vertex logarithm with the per-fragment one: a large triangle bends according to its vertices'
// logarithms, interpolated in screen space; small triangles hardly bend. The formulas are written out here.
#include <array>
#include <cmath>

#include "gl_test.h"
#include "render/probe.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::params_with;

constexpr glm::ivec2 logarithm_px(64, 64);
constexpr double log_near = 0.5, log_far = 40.0;

using Corners = std::array<glm::dvec3, 3>;  ///< x and y are in NDC, z is the distance

double logarithm(double distance) {
    return std::log(distance / log_near) / std::log(log_far / log_near);
}

/// Returns the weights of the vertices at a screen point.
glm::dvec3 weights_at(const Corners& corners, const glm::dvec2& point) {
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    const glm::dvec2 a(corners[0]), b(corners[1]), c(corners[2]);
    const double whole = cross(b - a, c - a);
    return {cross(b - point, c - point) / whole, cross(c - point, a - point) / whole,
            cross(a - point, b - point) / whole};
}

class LogarithmPerVertex : public testing::GlTest {
protected:
    /// Draws nothing but the triangle, cut into `cuts`² triangles, and reads back all pixels.
    static CellBlock block_of(const Corners& corners, int cuts, const std::string& format, bool orthographic,
                              bool per_vertex) {
        Mesh mesh;
        const auto place = [&](int i, int j) {
            const double u = static_cast<double>(i) / cuts, v = static_cast<double>(j) / cuts;
            glm::dvec3 sum(0.0);
            const glm::dvec3 weights(1.0 - u - v, u, v);
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3& corner = corners[static_cast<std::size_t>(k)];
                const double spread = orthographic ? 3.0 : std::tan(glm::radians(20.0)) * corner.z;
                sum += weights[k] * glm::dvec3(corner.x * spread, corner.y * spread, -corner.z);
            }
            return glm::vec3(sum);
        };
        const auto add = [&](glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
            for (const glm::ivec2 at : {a, b, c}) {
                mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
                mesh.positions.push_back(place(at.x, at.y));
                mesh.normals.push_back({0, 0, 1});
            }
        };
        for (int i = 0; i < cuts; ++i)
            for (int j = 0; i + j < cuts; ++j) {
                add({i, j}, {i + 1, j}, {i, j + 1});
                if (i + j + 1 < cuts) add({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
            }
        const Scene scene = testing::scene_of({testing::object("triangle", mesh, {0, 0, 0})});
        const Params params = params_with(
            {"camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0", "shadow.enabled=false",
             "reflection.enabled=false", "plane.extent=0.001", "plane.equation=[0,1,0,1000000]", "projection.near=0.5",
             "projection.far=40", "projection.fovy=40", "projection.height=6", "depth.mapping=logarithmic",
             "depth.format=" + format, orthographic ? "projection.type=orthographic" : "projection.type=perspective",
             per_vertex ? "depth.logarithm_per_vertex=true" : "depth.logarithm_per_vertex=false"});
        const Derived derived = derive_for(params, scene, logarithm_px);
        PixelProbe probe;
        EXPECT_TRUE(probe.prepare(renderer(), plan(params, derived), scene, derived, logarithm_px));
        return probe.block({0, 0}, logarithm_px);
    }
};

TEST_F(LogarithmPerVertex, BendsALargeTriangleAsInterpolationPredicts) {
    Random random(seed);
    for (const std::string format : {"d8", "d16", "d24", "d32f"})
        for (const bool orthographic : {false, true}) {
            Corners corners{glm::dvec3(-0.9, -0.9, 0), glm::dvec3(0.95, -0.8, 0), glm::dvec3(-0.1, 0.9, 0)};
            for (glm::dvec3& corner : corners) corner.z = std::exp(random.number(std::log(0.6), std::log(35.0)));
            corners[0].z = 0.7;
            corners[1].z = 33.0;
            const CellBlock per_vertex = block_of(corners, 1, format, orthographic, true);
            const CellBlock per_fragment = block_of(corners, 1, format, orthographic, false);
            double most_bent = 0.0;
            int compared = 0;
            for (int y = 0; y < logarithm_px.y; ++y)
                for (int x = 0; x < logarithm_px.x; ++x) {
                    const glm::dvec2 point((x + 0.5) / 32.0 - 1.0, 1.0 - (y + 0.5) / 32.0);
                    const glm::dvec3 weights = weights_at(corners, point);
                    if (std::min({weights.x, weights.y, weights.z}) < 0.02) continue;
                    double interpolated = 0.0, inverse = 0.0, distance = 0.0;
                    for (int k = 0; k < 3; ++k) {
                        const double z = corners[static_cast<std::size_t>(k)].z;
                        interpolated += weights[k] * logarithm(z);
                        inverse += weights[k] / z;
                        distance += weights[k] * z;
                    }
                    const double exact = logarithm(orthographic ? distance : 1.0 / inverse);
                    const double found = per_vertex.at({x, y}).window_depth;
                    const double half_code = format == "d8" ? 0.51 / 255.0 : format == "d16" ? 0.51 / 65535.0 : 0.0;
                    EXPECT_NEAR(found, interpolated, half_code + 2e-5) << format << " " << x << ", " << y;
                    EXPECT_NEAR(per_fragment.at({x, y}).window_depth, exact, half_code + 1e-4) << format;
                    most_bent = std::max(most_bent, std::abs(interpolated - exact));
                    ++compared;
                }
            EXPECT_GT(compared, 1000);
            EXPECT_GT(most_bent, 0.1) << "no bend is visible";
        }
}

TEST_F(LogarithmPerVertex, IsNearlyExactOnSmallTriangles) {
    for (const bool orthographic : {false, true}) {
        const Corners corners{glm::dvec3(-0.9, -0.9, 0.7), glm::dvec3(0.95, -0.8, 33), glm::dvec3(-0.1, 0.9, 5)};
        const CellBlock exact = block_of(corners, 1, "d24", orthographic, false);
        double before = 10.0;
        for (const int cuts : {1, 8, 64}) {
            const CellBlock found = block_of(corners, cuts, "d24", orthographic, true);
            double worst = 0.0;
            for (std::size_t i = 0; i < found.cells.size(); ++i)
                if (found.cells[i].window_depth < 1.0 && exact.cells[i].window_depth < 1.0)
                    worst = std::max(worst, std::abs(found.cells[i].window_depth - exact.cells[i].window_depth));
            EXPECT_LT(worst, before / 3.0) << cuts;
            before = worst;
        }
        EXPECT_LT(before, 0.02);
    }
}

TEST_F(LogarithmPerVertex, HasNoEffectWithOtherMappings) {
    const Scene scene = testing::scene_named("torus-and-boxes");
    for (const char* const mapping : {"depth.mapping=standard", "depth.mapping=reversed"})
        EXPECT_EQ(draw(params_with({mapping, "depth.logarithm_per_vertex=true"}), scene, {160, 90}),
                  draw(params_with({mapping}), scene, {160, 90}));
}

}  // namespace
}  // namespace viewing
