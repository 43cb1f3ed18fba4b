#include "image/image_size.h"

namespace viewing {

std::string image_size_rule(int most_pixels) {
    return "each side must be from 1 to " + std::to_string(largest_image_side) + " and the picture at most " +
           std::to_string(most_pixels / 1'000'000) + " million pixels";
}

}  // namespace viewing
