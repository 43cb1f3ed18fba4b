#include "ui/window/fonts.h"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/window/font_files.h"

namespace viewing {
namespace {

// Latin and typographic signs. The remaining math signs come from DejaVu Sans, merged below.
constexpr ImWchar text_ranges[] = {0x0020, 0x00FF, 0x2010, 0x2026, 0x2032, 0x2033, 0x2070, 0x208E, 0x20AC,
                                   0x20AC, 0x2190, 0x2193, 0x2212, 0x2212, 0x2260, 0x2265, 0};
constexpr ImWchar sign_ranges[] = {0x0391, 0x03C9, 0x1D40, 0x1D47, 0x2113, 0x2113, 0x2070, 0x209C, 0x2190,
                                   0x21FF, 0x2200, 0x22FF, 0x2308, 0x230B, 0x2318, 0x2318, 0x25A0, 0x25FF,
                                   0x2600, 0x2604, 0x2713, 0x2717, 0x26A0, 0x26A0, 0x27F5, 0x27F7, 0};
constexpr ImWchar box = 0x25A1;  // □

ImFont* add(const char* file, float size_px, const ImWchar* ranges, bool merge, int oversampling = 2) {
    const std::span<const std::byte> bytes = font_file(file);
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;  // ImGui only reads it
    config.MergeMode = merge;
    config.OversampleH = oversampling;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    std::string_view(file).copy(config.Name, sizeof(config.Name) - 1);
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<std::byte*>(bytes.data()),
                                                      static_cast<int>(bytes.size()), size_px, &config, ranges);
}

/// A font file, and the Korean file of the same weight.
struct Face {
    const char *latin, *korean;
};
constexpr Face regular{"Inter-Regular.otf", "NanumBarunGothic.ttf"},
    semibold{"Inter-SemiBold.otf", "NanumBarunGothicBold.ttf"},
    mono{"JetBrainsMono-Regular.ttf", "NanumBarunGothic.ttf"};

constexpr float usual_korean = 0.95F;  ///< size of Korean characters relative to Latin ones
constexpr float small_korean = 1.08F;  ///< in small type, syllables of three parts need this size

ImFont* font(const Face& face, float size_px, const ImWchar* korean, float korean_size = usual_korean) {
    size_px = std::round(size_px);
    ImFont* const font = add(face.latin, size_px, text_ranges, false);
    font->FallbackChar = box;
    add("DejaVuSans.ttf", std::round(size_px * 0.95F), sign_ranges, true);
    if (korean) add(face.korean, std::round(size_px * korean_size), korean, true, 1);
    return font;
}

/// A filled atlas, and what it was filled for.
struct LoadedFonts {
    float scale = 0.0F;
    TypeSizes type;
    std::vector<ImWchar> syllables;  ///< ranges that end with 0, to which the atlas refers; empty: no Korean
    widgets::Fonts fonts;
    ImFontAtlas* atlas = nullptr;
};

/// Owns atlases that no context uses, the latest last.
struct KeptFonts {
    std::vector<LoadedFonts> all;

    KeptFonts() = default;
    ~KeptFonts() {
        for (const LoadedFonts& one : all) IM_DELETE(one.atlas);
    }
    KeptFonts(const KeptFonts&) = delete;
    KeptFonts& operator=(const KeptFonts&) = delete;
};
KeptFonts kept;
std::vector<LoadedFonts> in_use;  // each atlas belongs to its context; some contexts may no longer exist

std::vector<ImWchar> copied(const ImWchar* ranges) {
    std::vector<ImWchar> all;
    if (!ranges) return all;
    while (*ranges != 0) all.push_back(*ranges++);
    all.push_back(0);
    return all;
}

}  // namespace

widgets::Fonts load_fonts(float scale, Syllables& korean, const TypeSizes& type) {
    const bool has_korean =
        korean.has_any() && !font_file(regular.korean).empty() && !font_file(semibold.korean).empty();
    LoadedFonts made{
        scale, type, copied(korean.ranges(has_korean ? font_file(regular.korean) : std::span<const std::byte>())), {}};
    keep_fonts();
    ImFontAtlas*& own = ImGui::GetIO().Fonts;  // the context deletes it
    const auto same = std::find_if(kept.all.begin(), kept.all.end(), [&](const LoadedFonts& one) {
        return one.scale == scale && one.type == type && one.syllables == made.syllables;
    });
    if (same != kept.all.end()) {
        IM_DELETE(own);
        own = same->atlas;
        ImGui::GetIO().FontDefault = same->fonts.text;
        in_use.push_back(std::move(*same));
        kept.all.erase(same);
        return in_use.back().fonts;
    }
    ImFontAtlas& atlas = *own;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    // In Inter and JetBrains Mono, the em is larger than the letters: 14 design pixels of type need a 16-pixel font.
    const ImWchar* const syllables = made.syllables.empty() ? nullptr : made.syllables.data();
    widgets::Fonts& fonts = made.fonts;
    fonts.text = font(regular, 16.0F * scale, syllables);
    fonts.heading = font(semibold, 16.0F * scale, syllables);
    fonts.note = font(regular, type.small * scale, syllables, small_korean);
    fonts.number = font(mono, 16.0F * scale, syllables);
    fonts.small_number = font(mono, type.small * scale, syllables, small_korean);
    fonts.matrix = type.matrix == TypeSizes{}.matrix ? fonts.number : font(mono, type.matrix * scale, syllables);
    fonts.caption = font(regular, type.caption * scale, syllables);
    ImGui::GetIO().FontDefault = fonts.text;
    made.atlas = &atlas;
    in_use.push_back(std::move(made));  // its ranges stay where they are
    return in_use.back().fonts;
}

void keep_fonts() {
    constexpr std::size_t most_kept = 2;
    ImFontAtlas*& own = ImGui::GetIO().Fonts;
    const auto used = std::find_if(in_use.begin(), in_use.end(), [&](const auto& one) { return one.atlas == own; });
    if (used == in_use.end()) return;
    const ImVector<ImFont*>& fonts = own->Fonts;  // a new atlas may have the address of a deleted one
    const bool is_filled = fonts.Size > 1 && fonts.front() == used->fonts.text && fonts.back() == used->fonts.caption;
    if (is_filled) {
        IM_FREE(std::exchange(own->TexPixelsRGBA32, nullptr));  // four times the size of the coverage, and made from it
        kept.all.push_back(std::move(*used));
        own = IM_NEW(ImFontAtlas)();
        ImGui::GetIO().FontDefault = nullptr;
    }
    in_use.erase(used);
    if (kept.all.size() <= most_kept) return;
    IM_DELETE(kept.all.front().atlas);
    kept.all.erase(kept.all.begin());
}

GlyphFace face_of(const ImFont& font, ImWchar character) {
    GlyphFace first;
    for (const ImFontConfig& config : std::span(font.ConfigData, static_cast<std::size_t>(font.ConfigDataCount))) {
        stbtt_fontinfo info;
        if (!stbtt_InitFont(&info, static_cast<const unsigned char*>(config.FontData), 0)) continue;
        const float em_px =
            stbtt_ScaleForPixelHeight(&info, config.SizePixels) / stbtt_ScaleForMappingEmToPixels(&info, 1.0F);
        const GlyphFace face{config.Name, em_px};
        if (first.em_px == 0.0F) first = face;
        bool is_in_ranges = false;
        for (const ImWchar* range = config.GlyphRanges; range && range[0] != 0; range += 2)
            is_in_ranges = is_in_ranges || (character >= range[0] && character <= range[1]);
        if (is_in_ranges && stbtt_FindGlyphIndex(&info, character) != 0) return face;
    }
    return first;
}

widgets::Fonts load_fonts(float scale) {
    Syllables none;
    return load_fonts(scale, none);
}

}  // namespace viewing
