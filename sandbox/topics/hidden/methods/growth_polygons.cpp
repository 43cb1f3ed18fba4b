// The polygons for measuring how costs grow. Read growth.cpp next.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

#include "topics/hidden/methods/growth.h"

namespace viewing {
namespace {

constexpr double small_radius = 0.025;  ///< of a small triangle's sphere: its diameter is 2.5 % of the cube's side of 2

/// Random numbers that are the same with every standard library, unlike those of std::uniform_real_distribution.
class Chance {
public:
    explicit Chance(unsigned seed) : engine_(seed) {}

    double number(double min, double max) { return min + (max - min) * static_cast<double>(engine_()) / 4294967296.0; }

    glm::dvec3 in_cube() {
        const double x = number(-1.0, 1.0), y = number(-1.0, 1.0), z = number(-1.0, 1.0);
        return {x, y, z};
    }

    glm::dvec3 direction() {
        const double y = number(-1.0, 1.0), turn = number(0.0, glm::two_pi<double>());
        const double radius = std::sqrt(1.0 - y * y);
        return {radius * std::cos(turn), y, radius * std::sin(turn)};
    }

private:
    std::mt19937 engine_;
};

std::vector<glm::dvec3> corners_of_a_triangle(GrowthScene scene, Chance& chance) {
    std::vector<glm::dvec3> corners(3);
    const glm::dvec3 center = chance.in_cube();
    for (glm::dvec3& corner : corners) {
        corner = scene == GrowthScene::small_triangles ? center + small_radius * chance.direction() : chance.in_cube();
    }
    return corners;
}

/// Returns `count` of the polygons, evenly spaced in the list.
std::vector<Polygon> sampled(std::span<const Polygon> polygons, std::size_t count) {
    std::vector<Polygon> taken;
    taken.reserve(count);
    for (std::size_t i = 0; i < count; ++i) taken.push_back(polygons[i * polygons.size() / count]);
    return taken;
}

}  // namespace

std::vector<Polygon> growth_polygons(const GrowthRequest& request, int count) {
    const auto wanted = static_cast<std::size_t>(std::max(count, 0));
    if (request.scene == GrowthScene::own_polygons) {
        return sampled(request.own_polygons, std::min(wanted, request.own_polygons.size()));
    }
    std::vector<Polygon> polygons;
    polygons.reserve(wanted);
    Chance chance(request.seed);
    while (polygons.size() < wanted) {
        const int source = static_cast<int>(polygons.size());
        auto polygon = make_polygon(corners_of_a_triangle(request.scene, chance), source, source);
        if (polygon) polygons.push_back(std::move(*polygon));
    }
    return polygons;
}

}  // namespace viewing
