#include "lesson/blend.h"

#include <algorithm>

#include "state/fields.h"

namespace viewing {
Params blended(const Params& from, const Params& to, double share) {
    if (share >= 1.0) return to;
    Params begin = from, result = to;
    for (const Field& field : fields()) {
        const std::size_t elements = std::min(element_count(field, begin), element_count(field, result));
        for (std::size_t element = 0; element < elements; ++element) blend_field(field, begin, result, share, element);
    }
    return result;
}

}  // namespace viewing
