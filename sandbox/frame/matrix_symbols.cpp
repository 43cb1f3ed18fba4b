#include "frame/matrix_symbols.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

namespace viewing {
namespace {

/// Names of more than one letter; every other letter is a separate symbol.
constexpr std::string_view words[] = {"right", "up", "back", "eye", "aspect"};

bool is_word(std::string_view letters) {
    return std::find(std::begin(words), std::end(words), letters) != std::end(words);
}

bool is_letter(char sign) {
    return std::isalpha(static_cast<unsigned char>(sign)) != 0;
}

std::string replaced(std::string text, std::string_view part, std::string_view by) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

/// Returns the letters from `at` on, including an index ("l_x") if `with_index` is set.
std::string_view letters_at(std::string_view text, std::size_t at, bool with_index) {
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || (with_index && text[end] == '_'))) ++end;
    return text.substr(at, end - at);
}

MatrixSymbols transposed(MatrixSymbols symbols) {
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < row; ++column)
            std::swap(symbols[4 * row + column], symbols[4 * column + row]);
    return symbols;
}

}  // namespace

MatrixSymbols shadow_symbols(bool by_rows) {
    const MatrixSymbols symbols{"Π·L - l_x n_x", "-l_x n_y",      "-l_x n_z",      "-l_x d",  //
                                "-l_y n_x",      "Π·L - l_y n_y", "-l_y n_z",      "-l_y d",  //
                                "-l_z n_x",      "-l_z n_y",      "Π·L - l_z n_z", "-l_z d",  //
                                "-l_w n_x",      "-l_w n_y",      "-l_w n_z",      "Π·L - l_w d"};
    return by_rows ? transposed(symbols) : symbols;
}

MatrixSymbols mirror_symbols(bool printed_by_rows, bool plus_2ab) {
    MatrixSymbols symbols{"1 - 2a^2", "-2ab",     "-2ac",     "-2ad",  //
                          "-2ab",     "1 - 2b^2", "-2bc",     "-2bd",  //
                          "-2ac",     "-2bc",     "1 - 2c^2", "-2cd",  //
                          "0",        "0",        "0",        "1"};
    if (plus_2ab) symbols[4] = "+2ab";
    return printed_by_rows ? transposed(symbols) : symbols;
}

MatrixSymbols view_symbols(bool swapped_order) {
    MatrixSymbols symbols{"right_x", "right_y", "right_z", "-right·eye",  //
                          "up_x",    "up_y",    "up_z",    "-up·eye",     //
                          "back_x",  "back_y",  "back_z",  "-back·eye",   //
                          "0",       "0",       "0",       "1"};
    if (swapped_order) std::tie(symbols[3], symbols[7], symbols[11]) = std::tuple{"-eye_x", "-eye_y", "-eye_z"};
    return symbols;
}

MatrixSymbols camera_symbols(bool swapped_order) {
    MatrixSymbols symbols{"right_x", "up_x", "back_x", "eye_x",  //
                          "right_y", "up_y", "back_y", "eye_y",  //
                          "right_z", "up_z", "back_z", "eye_z",  //
                          "0",       "0",    "0",      "1"};
    if (swapped_order)
        std::tie(symbols[3], symbols[7], symbols[11]) = std::tuple{"(R eye)_x", "(R eye)_y", "(R eye)_z"};
    return symbols;
}

MatrixSymbols projection_symbols(const Params& params, bool clip_zero_to_one) {
    const bool orthographic = params.projection.is_orthographic();
    const bool reversed = params.depth.mapping == DepthMapping::reversed;
    const char *scale = "c", *depth_scale = "(f+n)/(n-f)", *depth_shift = "2fn/(n-f)";
    if (orthographic) {
        scale = "2/h";
        depth_scale = "2/(n-f)";
        depth_shift = "(f+n)/(n-f)";
    }
    const bool infinite = std::isinf(params.projection.far);
    if (infinite) std::tie(depth_scale, depth_shift) = std::pair("-1", "-2n");
    if (reversed && infinite)
        std::tie(depth_scale, depth_shift) = clip_zero_to_one ? std::pair("0", "n") : std::pair("1", "2n");
    if (reversed && !infinite) {
        depth_scale = orthographic ? "2/(f-n)" : "(f+n)/(f-n)";
        depth_shift = orthographic ? "(f+n)/(f-n)" : "2fn/(f-n)";
        if (clip_zero_to_one) {
            depth_scale = orthographic ? "1/(f-n)" : "n/(f-n)";
            depth_shift = orthographic ? "f/(f-n)" : "fn/(f-n)";
        }
    }
    const char *wide = orthographic ? "2/(h·aspect)" : "c/aspect", *x_by_z = "0", *x_by_w = "0", *y_by_z = "0",
               *y_by_w = "0";
    if (params.projection.has_window()) {
        wide = orthographic ? "2/(r-l)" : "2n/(r-l)";
        scale = orthographic ? "2/(t-b)" : "2n/(t-b)";
        (orthographic ? x_by_w : x_by_z) = orthographic ? "(r+l)/(l-r)" : "(r+l)/(r-l)";
        (orthographic ? y_by_w : y_by_z) = orthographic ? "(t+b)/(b-t)" : "(t+b)/(t-b)";
    }
    return {wide,
            "0",
            x_by_z,
            x_by_w,  //
            "0",
            scale,
            y_by_z,
            y_by_w,  //
            "0",
            "0",
            depth_scale,
            depth_shift,  //
            "0",
            "0",
            orthographic ? "0" : "-1",
            orthographic ? "1" : "0"};
}

std::string symbol_as_latex(const std::string& symbol) {
    const std::string text = replaced(symbol, "R eye", "R\\,eye");
    std::string latex;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view letters = letters_at(text, at, false);
        latex += is_word(letters) ? "\\mathrm{" + std::string(letters) + "}"
                                  : text.substr(at, std::max<std::size_t>(letters.size(), 1));
        at += std::max<std::size_t>(letters.size(), 1);
    }
    return replaced(replaced(latex, "Π", "\\Pi "), "·", "\\cdot ");
}

std::string symbol_as_code(const std::string& symbol) {
    std::string text = replaced(symbol, "Π·L", "plane_dot_light");
    text = replaced(replaced(text, "·eye", "_dot_eye"), "(R eye)_", "R_eye_");
    text = replaced(text, "·", " ");
    std::string code, operand;  // the last operand, kept to write its square
    bool follows_operand = false;
    const auto put = [&](std::string_view next) {
        code += (follows_operand ? "*" : "") + std::string(next);
        operand = next;
        follows_operand = true;
    };
    for (std::size_t at = 0; at < text.size();) {
        std::size_t taken = 1;
        const std::string_view letters = letters_at(text, at, true);
        if (!letters.empty()) {
            taken = is_word(letters) || letters.find('_') != std::string_view::npos ? letters.size() : 1;
            put(letters.substr(0, taken));
        } else if (std::isdigit(static_cast<unsigned char>(text[at])) != 0) {
            put(text.substr(at, 1));
        } else if (text[at] == '^') {
            put(operand);
            taken = 2;
        } else if (text[at] != ' ') {
            if (text[at] == '(' && follows_operand) code += "*";
            code += text[at];
            follows_operand = text[at] == ')';
        }
        at += taken;
    }
    return code;
}

}  // namespace viewing
