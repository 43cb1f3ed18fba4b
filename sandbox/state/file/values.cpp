// Reads single values from JSON and writes them: numbers in range, colors, names, vectors, matrices.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "state/file/reader.h"
#include "text/words.h"

namespace viewing {

void refuse_value(const Json& value, const Where& where, const std::string& must_be) {
    where.refuse("must be " + must_be + ", got " + describe(value));
}

double read_number(const Json& value, const Where& where, const Range& range, bool may_be_infinite) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(number >= range.min && number <= range.max)) {
        refuse_value(value, where, "a number " + range_text(range) + (may_be_infinite ? ", or \"infinite\"" : ""));
    }
    return number;
}

int read_whole(const Json& value, const Where& where, int min, int max) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(number >= min && number <= max) || number != std::floor(number)) {
        refuse_value(value, where,
                     "a whole number " + range_text({static_cast<double>(min), static_cast<double>(max)}));
    }
    return static_cast<int>(number);
}

bool read_bool(const Json& value, const Where& where) {
    if (!value.is_boolean()) {
        refuse_value(value, where, "true or false");
    }
    return value.get<bool>();
}

Color read_color(const Json& value, const Where& where) {
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    std::uint32_t rgb = 0;
    const char* end = text.data() + text.size();
    const bool right_length = text.size() == 7 && text[0] == '#';
    if (!right_length || std::from_chars(text.data() + 1, end, rgb, 16).ptr != end) {
        refuse_value(value, where, "a color \"#rrggbb\" of six hexadecimal digits");
    }
    return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>((rgb >> 8U) & 0xffU),
            static_cast<std::uint8_t>(rgb & 0xffU)};
}

int read_choice(const Json& value, const Where& where, std::span<const char* const> names) {
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (text == names[i]) {
            return static_cast<int>(i);
        }
    }
    const std::vector<std::string> known(names.begin(), names.end());
    where.refuse("must be one of " + joined(names) + ", got " + describe(value) +
                 (value.is_string() ? suggestion(text, known) : ""));
}

glm::dvec3 read_vec3(const Json& value, const Where& where, const Range& range, const std::string& must_be) {
    if (!value.is_array() || value.size() != 3) {
        refuse_value(value, where, must_be);
    }
    glm::dvec3 vector;
    for (int i = 0; i < 3; ++i) {
        vector[i] = read_number(value[i], where.at(static_cast<std::size_t>(i)), range);
    }
    return vector;
}

glm::dmat4 read_matrix(const Json& value, const Where& where, const Range& range) {
    const std::string must_be = "null or 4 rows of 4 numbers";
    if (!value.is_array() || value.size() != 4) {
        refuse_value(value, where, must_be);
    }
    glm::dmat4 matrix;
    for (std::size_t row = 0; row < 4; ++row) {
        const Where where_row = where.at(row);
        if (!value[row].is_array() || value[row].size() != 4) {
            refuse_value(value[row], where_row, "a row of 4 numbers");
        }
        for (std::size_t column = 0; column < 4; ++column) {
            matrix[static_cast<int>(column)][static_cast<int>(row)] =
                read_number(value[row][column], where_row.at(column), range);
        }
    }
    return matrix;
}

std::string read_name(const Json& value, const Where& where) {
    constexpr std::size_t longest = 1024;
    if (!value.is_string()) {
        refuse_value(value, where, "a string");
    }
    const auto& name = value.get_ref<const std::string&>();
    if (name.empty()) {
        where.refuse("must not be empty");
    }
    if (name.size() > longest) {
        where.refuse("must not be longer than " + std::to_string(longest) + " bytes");
    }
    for (const char c : name) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            where.refuse("must not contain control characters");
        }
    }
    try {
        (void)value.dump();
    } catch (const Json::type_error&) {
        where.refuse("must be valid UTF-8");
    }
    return name;
}

void require_object(const Json& value, const Where& where, const std::string& must_be) {
    if (!value.is_object()) {
        refuse_value(value, where, must_be);
    }
}

void require_array(const Json& value, const Where& where, std::size_t max_count, const std::string& must_be) {
    if (!value.is_array() || value.size() > max_count) {
        refuse_value(value, where, must_be);
    }
}

void require_keys(const Json& object, const Where& where, const std::vector<std::string>& known) {
    require_object(object, where, "an object");
    for (const auto& [key, value] : object.items()) require_known_key(key, where, known);
}

void require_known_key(std::string_view key, const Where& where, std::span<const std::string> known) {
    if (std::find(known.begin(), known.end(), key) != known.end()) {
        return;
    }
    std::string all;
    for (const std::string& name : known) {
        all += (all.empty() ? "" : ", ") + name;
    }
    const std::string nearest = suggestion(key, known);
    where.key(key).refuse("no such field" + (nearest.empty() ? "; allowed here: " + all : nearest));
}

Json color_as_json(const Color& color) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned value : {color.r, color.g, color.b}) {
        text += digits[value >> 4U];
        text += digits[value & 15U];
    }
    return text;
}

Json vector_as_json(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

Json vector_as_json(const glm::dvec4& vector) {
    return {vector.x, vector.y, vector.z, vector.w};
}

Json matrix_as_json(const glm::dmat4& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        rows.push_back(vector_as_json(glm::dvec4(matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row])));
    }
    return rows;
}

}  // namespace viewing
