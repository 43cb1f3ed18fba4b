#include "figure/faces.h"

#include <hb-subset.h>

#include <memory>

namespace viewing {

std::map<std::string, std::set<char32_t>> characters_of(const Drawing& drawing) {
    std::map<std::string, std::set<char32_t>> all;
    for (const Mark& mark : drawing.marks)
        if (const Line* line = std::get_if<Line>(&mark.what))
            all[line->face].insert(line->characters.begin(), line->characters.end());
    return all;
}

std::vector<std::uint8_t> subset(std::span<const std::byte> file, const std::set<char32_t>& characters) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(file.data());
    std::vector<std::uint8_t> whole(bytes, bytes + file.size());
    const std::unique_ptr<hb_blob_t, decltype(&hb_blob_destroy)> blob(
        hb_blob_create(reinterpret_cast<const char*>(file.data()), static_cast<unsigned>(file.size()),
                       HB_MEMORY_MODE_READONLY, nullptr, nullptr),
        hb_blob_destroy);
    const std::unique_ptr<hb_face_t, decltype(&hb_face_destroy)> face(hb_face_create(blob.get(), 0), hb_face_destroy);
    const std::unique_ptr<hb_subset_input_t, decltype(&hb_subset_input_destroy)> input(hb_subset_input_create_or_fail(),
                                                                                       hb_subset_input_destroy);
    if (!input) return whole;
    for (const char32_t character : characters) hb_set_add(hb_subset_input_unicode_set(input.get()), character);
    // Each character has its own position, so the tables for kerning and ligatures are not needed.
    hb_set_t* const dropped = hb_subset_input_set(input.get(), HB_SUBSET_SETS_DROP_TABLE_TAG);
    for (const hb_tag_t table : {HB_TAG('G', 'S', 'U', 'B'), HB_TAG('G', 'P', 'O', 'S'), HB_TAG('G', 'D', 'E', 'F'),
                                 HB_TAG('k', 'e', 'r', 'n')})
        hb_set_add(dropped, table);
    const std::unique_ptr<hb_face_t, decltype(&hb_face_destroy)> made(hb_subset_or_fail(face.get(), input.get()),
                                                                      hb_face_destroy);
    if (!made) return whole;
    const std::unique_ptr<hb_blob_t, decltype(&hb_blob_destroy)> small(hb_face_reference_blob(made.get()),
                                                                       hb_blob_destroy);
    unsigned length = 0;
    const auto* const data = reinterpret_cast<const std::uint8_t*>(hb_blob_get_data(small.get(), &length));
    return length > 0 ? std::vector<std::uint8_t>(data, data + length) : whole;
}

std::string utf8(char32_t character) {
    const auto tail = [character](int shift) { return static_cast<char>(0x80U | (character >> shift & 0x3FU)); };
    if (character < 0x80U) return {static_cast<char>(character)};
    if (character < 0x800U) return {static_cast<char>(0xC0U | character >> 6U), tail(0)};
    if (character < 0x10000U) return {static_cast<char>(0xE0U | character >> 12U), tail(6), tail(0)};
    return {static_cast<char>(0xF0U | character >> 18U), tail(12), tail(6), tail(0)};
}

}  // namespace viewing
