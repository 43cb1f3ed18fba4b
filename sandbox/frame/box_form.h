// What values a linear form takes in a box, rounding included. Part of box_tree.h's questions.
#pragma once

#include "geometry/mesh.h"

namespace viewing {

/// The form a·(p, 1) of points p of a space, for boxes of a model in that space.
class BoxForm {
public:
    /// `summed`: the sizes of the terms that `form` has been added up from, where they are larger than its own.
    BoxForm(const glm::dvec4& form, const glm::dmat4& space_from_model, const glm::dvec4& summed = glm::dvec4(0.0))
        : form_(form * space_from_model) {
        for (int column = 0; column < 4; ++column)
            sizes_[column] = glm::dot(glm::max(glm::abs(form), summed), glm::abs(space_from_model[column]));
    }

    /// No point of the box has a lesser value, nor does it get one when it is computed.
    double least(const Bounds& box) const { return middle(box) - reach(box); }
    double greatest(const Bounds& box) const { return middle(box) + reach(box); }

private:
    double middle(const Bounds& box) const { return glm::dot(form_, glm::dvec4(box.center(), 1.0)); }
    double reach(const Bounds& box) const {
        constexpr double rounding = 1e-13;  // some hundreds of units in the last place
        const glm::dvec3 half = 0.5 * box.size();
        return glm::dot(glm::abs(glm::dvec3(form_)), half) +
               rounding * (glm::dot(glm::dvec3(sizes_), glm::abs(box.center()) + half) + sizes_.w);
    }

    glm::dvec4 form_;
    glm::dvec4 sizes_;  ///< of the terms of a value
};

}  // namespace viewing
