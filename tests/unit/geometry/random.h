// Seeded random values for property tests; the seed is printed with every failure.
#pragma once

#include <glm/glm.hpp>
#include <random>

#include "geometry/camera.h"

namespace viewing {

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double number(double min, double max) { return std::uniform_real_distribution<double>(min, max)(engine_); }
    glm::dvec3 vec3(double limit) { return {number(-limit, limit), number(-limit, limit), number(-limit, limit)}; }
    glm::dvec3 direction() {
        glm::dvec3 v(0.0);
        while (glm::length(v) < 0.1) {
            v = vec3(1.0);
        }
        return glm::normalize(v);
    }
    Angles angles() { return {number(-180, 180), number(-89, 89), number(-180, 180)}; }

private:
    std::mt19937 engine_;
};

inline constexpr unsigned seed = 20201105;

/// Returns the largest difference between corresponding entries.
inline double worst_difference(const glm::dmat4& a, const glm::dmat4& b) {
    double worst = 0.0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            worst = std::max(worst, std::abs(a[column][row] - b[column][row]));
        }
    }
    return worst;
}

}  // namespace viewing
