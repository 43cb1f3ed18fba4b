#include "state/mesh/obj_vertices.h"

#include <limits>

namespace viewing {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr int longest_chain = 16;

}  // namespace

/// Scrambles a key, so that keys that follow a pattern do not share buckets. Source: Steele, Lea and Flood 2014
/// (SplitMix64).
std::size_t ObjVertices::Mixed::operator()(std::uint64_t key) const {
    key += 0x9e3779b97f4a7c15ULL;
    key = (key ^ (key >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    key = (key ^ (key >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<std::size_t>(key ^ (key >> 31U));
}

ObjVertices::ObjVertices(const ObjContent& content, Mesh& mesh)
    : content_(content), mesh_(mesh), first_(content.positions.size(), none) {
    // Most positions have only one vertex.
    made_.reserve(content.positions.size());
    mesh.positions.reserve(content.positions.size());
    mesh.normals.reserve(content.positions.size());
}

std::uint32_t ObjVertices::vertex(const ObjCorner& corner) {
    std::uint32_t* link = &first_[corner.position];
    for (int length = 0; length < longest_chain; ++length) {
        ++steps_;
        if (*link == none) {
            *link = static_cast<std::uint32_t>(made_.size());
            return made(corner);
        }
        if (made_[*link].normal == corner.normal) return *link;
        link = &made_[*link].next;
    }
    const std::uint64_t key =
        (static_cast<std::uint64_t>(corner.position) << 32U) | static_cast<std::uint32_t>(corner.normal);
    const auto [found, is_new] = further_.try_emplace(key, static_cast<std::uint32_t>(made_.size()));
    return is_new ? made(corner) : found->second;
}

std::uint32_t ObjVertices::made(const ObjCorner& corner) {
    made_.push_back({corner.normal, none});
    mesh_.positions.emplace_back(content_.positions[corner.position]);
    mesh_.normals.push_back(content_.normals[corner.normal]);
    return static_cast<std::uint32_t>(made_.size() - 1);
}

}  // namespace viewing
