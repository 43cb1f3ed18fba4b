#include "topics/hidden/shown/polygon_names.h"

#include "text/catalogue.h"

namespace viewing {
namespace {

struct PolygonPlace {
    std::string object;
    int number = 0;  ///< 0 for an exact curved shape
};

int object_at(const SceneSurface* surface, int source) {
    if (!surface || source < 0 || source >= surface->source_count()) return -1;
    const int object = surface->object_of(source);
    return object < std::ssize(surface->scene.objects) ? object : -1;
}

PolygonPlace place_of(const SceneSurface* surface, int source) {
    const int object = object_at(surface, source);
    if (object < 0) return {};
    const auto index = static_cast<std::size_t>(object);
    const std::string& name = surface->scene.objects[index].description.name;
    return {name.empty() ? say("object {number}", "number"_a = object + 1) : object_text(name),
            surface->curved_of(source) ? 0 : source - surface->first_source[index] + 1};
}

}  // namespace

std::string polygon_name(const SceneSurface* surface, int source) {
    const PolygonPlace place = place_of(surface, source);
    return place.number == 0
               ? place.object
               : say("polygon {number} of {object}", "number"_a = place.number, "object"_a = place.object);
}

std::string listed_name(const SceneSurface* surface, int source) {
    const PolygonPlace place = place_of(surface, source);
    return place.number == 0 ? place.object
                             : say("{object}, polygon {number}", "object"_a = place.object, "number"_a = place.number);
}

std::string brief_name(const SceneSurface* surface, int source) {
    const PolygonPlace place = place_of(surface, source);
    return place.number == 0 ? place.object : place.object + " " + std::to_string(place.number);
}

ImU32 polygon_color(const SceneSurface* surface, int source) {
    const int object = object_at(surface, source);
    if (object < 0) return 0;
    const Color& color = surface->scene.objects[object].description.color;
    return IM_COL32(color.r, color.g, color.b, 255);
}

}  // namespace viewing
