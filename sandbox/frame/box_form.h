// Bounds the values of a linear form over a box, including rounding errors. Queries of a BoxTree use it.
#pragma once

#include "geometry/mesh.h"

namespace viewing {

/// The linear form a·(p, 1) of a point p in some space, evaluated over boxes in a model's own space.
class BoxForm {
public:
    /// `summed`: the magnitudes of the terms that were summed to get `form`, if they exceed those of `form` itself.
    BoxForm(const glm::dvec4& form, const glm::dmat4& space_from_model, const glm::dvec4& summed = glm::dvec4(0.0))
        : form_(form * space_from_model) {
        for (int column = 0; column < 4; ++column)
            sizes_[column] = glm::dot(glm::max(glm::abs(form), summed), glm::abs(space_from_model[column]));
    }

    /// Return conservative bounds: neither the exact nor the computed value at any point in the box lies beyond them.
    double least(const Bounds& box) const { return middle(box) - reach(box); }
    double greatest(const Bounds& box) const { return middle(box) + reach(box); }

private:
    double middle(const Bounds& box) const { return glm::dot(form_, glm::dvec4(box.center(), 1.0)); }
    double reach(const Bounds& box) const {
        constexpr double rounding = 1e-13;  // a few hundred units in the last place
        const glm::dvec3 half = 0.5 * box.size();
        return glm::dot(glm::abs(glm::dvec3(form_)), half) +
               rounding * (glm::dot(glm::dvec3(sizes_), glm::abs(box.center()) + half) + sizes_.w);
    }

    glm::dvec4 form_;
    glm::dvec4 sizes_;  ///< magnitudes of the terms that add up to a value
};

}  // namespace viewing
