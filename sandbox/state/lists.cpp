#include "state/lists.h"

#include <algorithm>
#include <cassert>

namespace viewing {

namespace {

template <typename Array, typename Value>
void remove_and_move_up(Array& array, std::size_t index, const Value& fill) {
    std::move(array.begin() + static_cast<std::ptrdiff_t>(index) + 1, array.end(),
              array.begin() + static_cast<std::ptrdiff_t>(index));
    array.back() = fill;
}

template <typename Element>
void remove_element(std::vector<Element>& list, std::size_t index, int& chosen_number) {
    assert(list.size() > 1 && index < list.size());
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
    if (chosen_number > static_cast<int>(index + 1)) {
        --chosen_number;
    }
    chosen_number = std::min(chosen_number, static_cast<int>(list.size()));
}

}  // namespace

void remove_light(Params& params, std::size_t index) {
    remove_element(params.lights, index, params.view.light);
    for (PlaneOverrides& overrides : params.overrides) {
        remove_and_move_up(overrides.shadowed_world_from_world, index, std::nullopt);
    }
}

void remove_plane(Params& params, std::size_t index) {
    remove_element(params.planes, index, params.view.plane);
    remove_and_move_up(params.overrides, index, PlaneOverrides{});
}

}  // namespace viewing
