#include <cairo-ft.h>
#include <cairo-pdf.h>

#include <map>
#include <memory>
#include <type_traits>

#include "embedded/fonts.h"
#include "figure/faces.h"
#include "figure/write.h"
#include "image/figure_note.h"

namespace viewing {
namespace {

template <typename T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

cairo_status_t append(void* to, const unsigned char* data, unsigned length) {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(to);
    bytes.insert(bytes.end(), data, data + length);
    return CAIRO_STATUS_SUCCESS;
}

/// This program's fonts, loaded for Cairo.
class PdfFaces {
public:
    PdfFaces() { FT_Init_FreeType(&library_); }
    ~PdfFaces() {
        for (auto& [name, face] : faces_) cairo_font_face_destroy(face.cairo);
        for (auto& [name, face] : faces_) FT_Done_Face(face.freetype);
        FT_Done_FreeType(library_);
    }
    PdfFaces(const PdfFaces&) = delete;
    PdfFaces& operator=(const PdfFaces&) = delete;

    struct Face {
        FT_Face freetype;
        cairo_font_face_t* cairo;
    };

    const Face& of(const std::string& name) {
        const auto known = faces_.find(name);
        if (known != faces_.end()) return known->second;
        const std::span<const std::byte> file = embedded_font(name);
        Face face{};
        FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(file.data()), static_cast<FT_Long>(file.size()),
                           0, &face.freetype);
        face.cairo = cairo_ft_font_face_create_for_ft_face(face.freetype, FT_LOAD_NO_HINTING);
        return faces_.emplace(name, face).first->second;
    }

private:
    FT_Library library_ = nullptr;
    std::map<std::string, Face> faces_;
};

class PdfWriter {
public:
    PdfWriter(cairo_t* page, PdfFaces& faces) : page_(page), faces_(faces) {}

    void write(const Mark& mark) {
        cairo_save(page_);
        rectangle(mark.clip);
        cairo_clip(page_);
        std::visit([this](const auto& what) { write(what); }, mark.what);
        cairo_restore(page_);
    }

private:
    void set(const Ink& ink) {
        cairo_set_source_rgba(page_, ink.r / 255.0, ink.g / 255.0, ink.b / 255.0, ink.a / 255.0);
    }

    void rectangle(const DrawingBox& box) {
        cairo_rectangle(page_, box.min.x, box.min.y, box.max.x - box.min.x, box.max.y - box.min.y);
    }

    void go_round(const std::vector<Ring>& rings) {
        for (const Ring& ring : rings) {
            cairo_new_sub_path(page_);
            for (const glm::vec2& corner : ring) cairo_line_to(page_, corner.x, corner.y);
            cairo_close_path(page_);
        }
    }

    void write(const Shape& shape) {
        go_round(shape.rings);
        set(shape.ink);
        cairo_fill(page_);
    }

    void write(const Shade& shade) {
        const DrawingBox& box = shade.box;
        const glm::vec2 end = shade.is_vertical ? glm::vec2(box.min.x, box.max.y) : glm::vec2(box.max.x, box.min.y);
        const Owned<cairo_pattern_t> pattern(cairo_pattern_create_linear(box.min.x, box.min.y, end.x, end.y),
                                             cairo_pattern_destroy);
        const auto stop = [&](double at, const Ink& ink) {
            cairo_pattern_add_color_stop_rgba(pattern.get(), at, ink.r / 255.0, ink.g / 255.0, ink.b / 255.0,
                                              ink.a / 255.0);
        };
        stop(0.0, shade.from);
        stop(1.0, shade.to);
        rectangle(box);
        cairo_set_source(page_, pattern.get());
        cairo_fill(page_);
    }

    void write(const Line& line) {
        const PdfFaces::Face& face = faces_.of(line.face);
        cairo_set_font_face(page_, face.cairo);
        cairo_set_font_size(page_, line.em_px);
        std::string text;
        std::vector<cairo_glyph_t> glyphs;
        std::vector<cairo_text_cluster_t> clusters;
        for (std::size_t i = 0; i < line.characters.size(); ++i) {
            const std::string character = utf8(line.characters[i]);
            text += character;
            glyphs.push_back(
                {FT_Get_Char_Index(face.freetype, line.characters[i]), line.lefts_px[i], line.baseline_px});
            clusters.push_back({static_cast<int>(character.size()), 1});
        }
        const int count = static_cast<int>(glyphs.size());
        set(line.ink);
        cairo_show_text_glyphs(page_, text.c_str(), static_cast<int>(text.size()), glyphs.data(), count,
                               clusters.data(), count, static_cast<cairo_text_cluster_flags_t>(0));
    }

    void write(const Inset& inset) {
        const Image& image = *inset.image;
        const Owned<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height),
                                             cairo_surface_destroy);
        copy(image, surface.get());
        if (inset.rings.empty())
            rectangle(inset.box);
        else
            go_round(inset.rings);
        cairo_clip(page_);
        const glm::vec2 scale = (inset.box.max - inset.box.min) / (inset.from.max - inset.from.min);
        cairo_translate(page_, inset.box.min.x - inset.from.min.x * scale.x,
                        inset.box.min.y - inset.from.min.y * scale.y);
        cairo_scale(page_, scale.x, scale.y);
        cairo_set_source_surface(page_, surface.get(), 0.0, 0.0);
        cairo_paint_with_alpha(page_, inset.tint.a / 255.0);
    }

    /// Copies pixels into Cairo's format, which is premultiplied and stores each pixel as one word in native byte
    /// order.
    static void copy(const Image& image, cairo_surface_t* surface) {
        unsigned char* const data = cairo_image_surface_get_data(surface);
        const int stride = cairo_image_surface_get_stride(surface);
        for (int y = 0; y < image.height; ++y) {
            auto* const row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
            const std::uint8_t* from = image.row(y);
            for (int x = 0; x < image.width; ++x, from += 4) {
                const auto channel = [&](int i) {
                    return (static_cast<std::uint32_t>(from[i]) * from[3] + 127U) / 255U;
                };
                row[x] = static_cast<std::uint32_t>(from[3]) << 24U | channel(0) << 16U | channel(1) << 8U | channel(2);
            }
        }
        cairo_surface_mark_dirty(surface);
    }

    cairo_t* page_;
    PdfFaces& faces_;
};

}  // namespace

std::vector<std::uint8_t> as_pdf(const Drawing& drawing, const VectorOptions& options) {
    std::vector<std::uint8_t> bytes;
    const double points_per_px = 72.0 / options.dpi;
    PdfFaces faces;  // must outlive the surface, which writes them when it is finished
    const Owned<cairo_surface_t> surface(
        cairo_pdf_surface_create_for_stream(append, &bytes, drawing.size_px.x * points_per_px,
                                            drawing.size_px.y * points_per_px),
        cairo_surface_destroy);
    // From PDF 1.5 on, cairo 1.18 compresses objects, so image/figure_note.cpp could not find the state in them.
    cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
    const auto tell = [&](cairo_pdf_metadata_t what, const std::string& text) {
        cairo_pdf_surface_set_metadata(surface.get(), what, text.c_str());
    };
    tell(CAIRO_PDF_METADATA_TITLE, options.title);
    tell(CAIRO_PDF_METADATA_CREATOR, "viewing-sandbox");
    tell(CAIRO_PDF_METADATA_KEYWORDS, note_as_keyword(options.note));
    tell(CAIRO_PDF_METADATA_CREATE_DATE, "");  // so that the same drawing gives the same bytes
    {
        const Owned<cairo_t> page(cairo_create(surface.get()), cairo_destroy);
        cairo_scale(page.get(), points_per_px, points_per_px);
        PdfWriter writer(page.get(), faces);
        for (const Mark& mark : drawing.marks) writer.write(mark);
        cairo_show_page(page.get());
    }
    cairo_surface_finish(surface.get());
    return bytes;
}

}  // namespace viewing
