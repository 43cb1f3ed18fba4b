#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "embedded/fonts.h"
#include "figure/faces.h"
#include "figure/write.h"
#include "image/figure_note.h"
#include "image/png.h"
#include "text/html.h"
#include "text/numbers.h"

namespace viewing {
namespace {

std::string rounded(float value, double parts) {
    const double nearest = std::round(static_cast<double>(value) * parts) / parts;
    return shortest_number(nearest == 0.0 ? 0.0 : nearest);
}

/// Rounds to a hundredth of a pixel, which is precise enough.
std::string px(float value) {
    return rounded(value, 100.0);
}

/// Rounds a scale so that the length of a whole picture is off by at most a hundredth of a pixel.
std::string factor(float value) {
    return rounded(value, 1e6);
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string painted(const char* what, const Ink& ink) {
    std::string text = attribute(what, hex_color(ink.r, ink.g, ink.b));
    if (ink.a != 255)
        text += attribute((std::string(what) + "-opacity").c_str(), px(static_cast<float>(ink.a) / 255.0F));
    return text;
}

std::string box_attributes(const DrawingBox& box) {
    return attribute("x", px(box.min.x)) + attribute("y", px(box.min.y)) +
           attribute("width", px(box.max.x - box.min.x)) + attribute("height", px(box.max.y - box.min.y));
}

std::string path_of(const std::vector<Ring>& rings) {
    std::string path;
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            path += (i == 0 ? "M" : "L") + px(ring[i].x) + " " + px(ring[i].y);
        path += "Z";
    }
    return path;
}

/// The embedded font's name in this file, its weight, and the fallback for viewers that ignore embedded fonts.
struct Css {
    std::string name, families;
    int weight = 400;
};

Css css_of(const std::string& face) {
    Css css{face.substr(0, face.rfind('.')), "Inter, sans-serif"};
    for (const auto& [begin, families] : {std::pair{"JetBrainsMono", "'JetBrains Mono', monospace"},
                                          {"NanumBarunGothic", "NanumBarunGothic, sans-serif"},
                                          {"DejaVuSans", "'DejaVu Sans', sans-serif"}})
        if (css.name.starts_with(begin)) css.families = families;
    if (css.name.ends_with("Bold")) css.weight = css.name.ends_with("SemiBold") ? 600 : 700;
    return css;
}

class SvgWriter {
public:
    SvgWriter(const Drawing& drawing, const VectorOptions& options) : drawing_(drawing), options_(options) {}

    std::string document() {
        for (const Mark& mark : drawing_.marks) write(mark);
        const auto inches = [&](float length_px) {
            return shortest_number(std::round(length_px / options_.dpi * 1e4) / 1e4) + "in";
        };
        const glm::vec2 size = drawing_.size_px;
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
               attribute("width", inches(size.x)) + attribute("height", inches(size.y)) +
               attribute("viewBox", "0 0 " + px(size.x) + " " + px(size.y)) + ">\n<title>" + escaped(options_.title) +
               "</title>\n" + note_as_svg(options_.note) + style() + "<defs>\n" + definitions_ + "</defs>\n" + body_ +
               "</svg>\n";
    }

private:
    std::string style() const {
        std::string text = "<style>\ntext { white-space: pre; font-variant-ligatures: none; font-kerning: none; }\n";
        int number = 0;
        for (const auto& [face, characters] : faces_) {
            const Css css = css_of(face);
            const std::string weight = "; font-weight: " + std::to_string(css.weight);
            text += "@font-face { font-family: '" + css.name + "'" + weight + "; src: url(data:font/" +
                    (face.ends_with(".otf") ? "otf" : "ttf") + ";base64," +
                    base64(subset(embedded_font(face), characters)) + "); }\n.f" + std::to_string(number++) +
                    " { font-family: '" + css.name + "', " + css.families + weight + "; }\n";
        }
        return text + "</style>\n";
    }

    void write(const Mark& mark) {
        clip_ = mark.clip;
        std::visit([this](const auto& what) { write(what); }, mark.what);
    }

    void write(const Shape& shape) {
        DrawingBox box{glm::vec2(1e9F), glm::vec2(-1e9F)};
        for (const Ring& ring : shape.rings)
            for (const glm::vec2& corner : ring) box = {glm::min(box.min, corner), glm::max(box.max, corner)};
        add(box, "<path" + attribute("d", path_of(shape.rings)) + painted("fill", shape.ink) + "/>");
    }

    void write(const Shade& shade) {
        const std::string id = "shade" + std::to_string(count_++);
        const auto stop = [](const char* offset, const Ink& ink) {
            return "<stop" + attribute("offset", offset) + attribute("stop-color", hex_color(ink.r, ink.g, ink.b)) +
                   attribute("stop-opacity", px(static_cast<float>(ink.a) / 255.0F)) + "/>";
        };
        definitions_ += "<linearGradient" + attribute("id", id) + attribute("x2", shade.is_vertical ? "0" : "1") +
                        attribute("y2", shade.is_vertical ? "1" : "0") + ">" + stop("0", shade.from) +
                        stop("1", shade.to) + "</linearGradient>\n";
        add(shade.box, "<rect" + box_attributes(shade.box) + attribute("fill", "url(#" + id + ")") + "/>");
    }

    void write(const Line& line) {
        std::string text, lefts;
        for (std::size_t i = 0; i < line.characters.size(); ++i) {
            text += utf8(line.characters[i]);
            lefts += (i == 0 ? "" : " ") + px(line.lefts_px[i]);
        }
        std::string element = "<text" + attribute("class", "f" + std::to_string(face_number(line.face))) +
                              attribute("font-size", px(line.em_px)) + attribute("x", lefts) +
                              attribute("y", px(line.baseline_px)) + painted("fill", line.ink);
        const float last = line.lefts_px.empty() ? 0.0F : line.lefts_px.back();
        const DrawingBox box{
            {line.lefts_px.empty() ? 0.0F : line.lefts_px.front(), line.baseline_px - 0.8F * line.em_px},
            {last + 0.5F * line.em_px, line.baseline_px + 0.2F * line.em_px}};
        add(box, element + ">" + escaped(text) + "</text>");
    }

    void write(const Inset& inset) {
        // Place the whole picture so that the visible part fills the box.
        const glm::vec2 scale = (inset.box.max - inset.box.min) / (inset.from.max - inset.from.min);
        const glm::vec2 origin = inset.box.min - inset.from.min * scale;
        std::string element = "<image" +
                              attribute("transform", "matrix(" + factor(scale.x) + " 0 0 " + factor(scale.y) + " " +
                                                         px(origin.x) + " " + px(origin.y) + ")") +
                              attribute("width", std::to_string(inset.image->width)) +
                              attribute("height", std::to_string(inset.image->height)) +
                              attribute("preserveAspectRatio", "none");
        if (inset.tint.a != 255) element += attribute("opacity", px(static_cast<float>(inset.tint.a) / 255.0F));
        element += attribute("href", "data:image/png;base64," + base64(encode_png(*inset.image))) + "/>";
        const std::string id = "part" + std::to_string(count_++);
        const std::string outline = inset.rings.empty() ? "<rect" + box_attributes(inset.box) + "/>"
                                                        : "<path" + attribute("d", path_of(inset.rings)) + "/>";
        definitions_ += "<clipPath" + attribute("id", id) + ">" + outline + "</clipPath>\n";
        add(inset.box, "<g" + attribute("clip-path", "url(#" + id + ")") + ">" + element + "</g>");
    }

    /// Adds an element, and gives it a clip path only if it extends beyond its clip.
    void add(const DrawingBox& box, const std::string& element) {
        const bool fits = box.min.x >= clip_.min.x - 0.5F && box.min.y >= clip_.min.y - 0.5F &&
                          box.max.x <= clip_.max.x + 0.5F && box.max.y <= clip_.max.y + 0.5F;
        if (fits) {
            body_ += element + "\n";
            return;
        }
        body_ += "<g" + attribute("clip-path", "url(#" + clip_id() + ")") + ">" + element + "</g>\n";
    }

    std::string clip_id() {
        const auto known = std::find(clips_.begin(), clips_.end(), clip_);
        const auto number = known - clips_.begin();
        const std::string id = "clip" + std::to_string(number);
        if (known == clips_.end()) {
            clips_.push_back(clip_);
            definitions_ += "<clipPath" + attribute("id", id) + "><rect" + box_attributes(clip_) + "/></clipPath>\n";
        }
        return id;
    }

    /// Returns the index of a font in the drawing, in the order in which style() numbers the fonts.
    std::ptrdiff_t face_number(const std::string& face) const {
        return std::distance(faces_.begin(), faces_.find(face));
    }

    const Drawing& drawing_;
    const VectorOptions& options_;
    const std::map<std::string, std::set<char32_t>> faces_ = characters_of(drawing_);
    std::string definitions_, body_;
    DrawingBox clip_;
    std::vector<DrawingBox> clips_;
    int count_ = 0;
};

}  // namespace

std::string as_svg(const Drawing& drawing, const VectorOptions& options) {
    return SvgWriter(drawing, options).document();
}

}  // namespace viewing
