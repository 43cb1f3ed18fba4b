#include "lesson/blend.h"

#include <algorithm>
#include <cmath>

#include "state/fields.h"

namespace viewing {
namespace {

/// Interpolates fields that consist of numbers; has one call operator for each such alternative of FieldRef.
struct Mix {
    const Field& field;
    const FieldRef& from;
    double share;

    double between(double a, double b) const {
        if (field.logarithmic && a > 0.0 && b > 0.0) return a * std::pow(b / a, share);
        return a + (b - a) * share;
    }
    void operator()(double* to) const { *to = between(*std::get<double*>(from), *to); }
    void operator()(glm::dvec3* to) const { entries(*std::get<glm::dvec3*>(from), *to); }
    void operator()(glm::dvec4* to) const { entries(*std::get<glm::dvec4*>(from), *to); }
    template <typename Other>
    void operator()(const Other&) const {}

private:
    template <typename Vector>
    void entries(const Vector& a, Vector& b) const {
        for (glm::length_t i = 0; i < Vector::length(); ++i) b[i] = between(a[i], b[i]);
    }
};

}  // namespace

Params blended(const Params& from, const Params& to, double share) {
    if (share >= 1.0) return to;
    Params begin = from, result = to;
    for (const Field& field : fields()) {
        const std::size_t elements = std::min(element_count(field, begin), element_count(field, result));
        for (std::size_t element = 0; element < elements; ++element) {
            const FieldRef source = field.in(begin, element);
            std::visit(Mix{field, source, share}, field.in(result, element));
        }
    }
    return result;
}

}  // namespace viewing
