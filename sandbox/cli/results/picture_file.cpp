#include "cli/results/picture_file.h"

#include <filesystem>
#include <iostream>

#include "image/note_parts.h"
#include "image/png.h"
#include "platform/text_file.h"
#include "state/file/state_json.h"
#include "text/words.h"

namespace viewing {
namespace {

std::string ending_of(const std::string& target) {
    return in_lower_case(std::filesystem::path(target).extension().string());
}

}  // namespace

bool is_vector_name(const std::string& target) {
    return ending_of(target) == ".svg" || ending_of(target) == ".pdf";
}

bool DrawnPicture::is_blank() const {
    if (image.rgba.empty()) return drawing.marks.empty();
    for (std::size_t at = 4; at < image.rgba.size(); ++at)
        if (image.rgba[at] != image.rgba[at % 4]) return false;
    return true;
}

std::string carried_state(const Params& params) {
    std::string state = write_state(params);
    if (can_carry(state)) return state;
    std::cerr << "the picture does not carry its state, which is " + longer_than(max_document_bytes) + "\n";
    return "";
}

std::vector<std::uint8_t> picture_file(const std::string& target, const DrawnPicture& picture,
                                       const VectorOptions& options) {
    if (!picture.depths.depths.empty()) return encode_depths(picture.depths, target);
    if (!is_vector_name(target)) return encode_png(picture.image, options.note, options.dpi);
    if (ending_of(target) == ".pdf") return as_pdf(picture.drawing, options);
    const std::string svg = as_svg(picture.drawing, options);
    return {svg.begin(), svg.end()};
}

}  // namespace viewing
