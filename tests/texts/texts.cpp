// The texts that the window can show, for tests/catalogue.
//
// texts SOURCES.pot…           prints one .pot file with the texts that xgettext found in the sources and those that
//                              the program itself lists: fields, presets and scenes. Omits what follows "##" in a
//                              label, since the window does not show it.
// texts --check ALL.pot KO.po  checks that the catalog has all of these texts and no others, that each translation has
//                              the same placeholders as its English text, and that places.h describes them. Prints a
//                              line for each error and then exits with status 1.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "places.h"
#include "state/fields.h"
#include "state/file/document.h"
#include "state/mesh/coplanar.h"
#include "state/presets.h"
#include "state/scene.h"
#include "text/po.h"

namespace viewing {
namespace {

/// Where a text appears: the files, and the program's name for the place ("field depth.test, label").
struct Origin {
    std::string files, said;
};
using Texts = std::map<std::string, Origin>;

std::vector<PoEntry> read(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(file), {}};
    if (!file) {
        std::cerr << path << ": cannot be read\n";
        std::exit(2);
    }
    Result<std::vector<PoEntry>> entries = read_po(content);
    if (!entries) {
        std::cerr << path << ": " << entries.error() << '\n';
        std::exit(1);
    }
    return *std::move(entries);
}

/// Returns whether the text has a word, that is, two letters in a row. Signs, symbols of formulas and names of axes are
/// not words.
bool has_word(std::string_view text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (is_letter(text[i - 1]) && is_letter(text[i])) return true;
    }
    return false;
}

void add(Texts& texts, std::string_view text, Origin origin) {
    const std::string_view shown = text.substr(0, text.find("##"));
    if (has_word(shown)) texts.emplace(shown, std::move(origin));
}

/// Adds an object's name without the number at its end.
void add_object(Texts& texts, const std::string& name, const std::string& where) {
    add(texts, name.substr(0, name.find_last_not_of("0123456789 ") + 1), {where, "name of an object"});
}

/// Adds the names of the objects of all scenes in a scene, preset or lesson.
void add_objects(Texts& texts, const Json& document, const std::string& where) {
    if (!document.is_structured()) return;
    for (const auto& [name, value] : document.items()) {
        if (name != "objects" || !value.is_array()) {
            add_objects(texts, value, where);
            continue;
        }
        for (const Json& object : value)
            if (object.is_object()) add_object(texts, object.value("name", ""), where);
    }
}

void add_tables(Texts& texts) {
    Params params;
    for (const Field& field : fields()) {
        const std::string name = "field " + std::string(field.path) + ", ";
        const std::pair<std::string_view, const char*> parts[] = {
            {field.label, "label"}, {field.help, "help"}, {field.unit, "unit"}};
        for (const auto& [text, part] : parts) add(texts, text, {"sandbox/state/fields.cpp", name + part});
    }
    for (const char* folder : {"scenes", "presets", "lessons"}) {
        std::set<std::filesystem::path> files;
        for (const auto& file : std::filesystem::directory_iterator(assets_directory() / folder))
            if (file.path().extension() == ".json") files.insert(file.path());
        for (const std::filesystem::path& file : files) {
            std::ifstream stream(file);
            add_objects(texts, Json::parse(stream), fmt::format("assets/{}/{}", folder, file.filename().string()));
        }
    }
    for (const ObjectDescription& object : coplanar_scene({}).objects)
        add_object(texts, object.name, "sandbox/state/mesh/coplanar.cpp");
    for (const auto& [files, kind] : {std::pair{presets(), "preset"}, std::pair{scenes(), "scene"}}) {
        for (const NamedFile& file : files) {
            const std::string path = fmt::format("assets/{}s/{}.json", kind, file.name);
            const std::pair<const std::string&, const char*> parts[] = {
                {file.title, "title"}, {file.about, "what it shows"}, {file.group, "group"}};
            for (const auto& [text, part] : parts)
                add(texts, text, {path, fmt::format("{} {}, {}", kind, file.name, part)});
        }
    }
}

std::string quote(std::string_view text) {
    std::string in_quotes = "\"";
    for (const char c : text) {
        if (c == '\n') {
            in_quotes += "\\n";
            continue;
        }
        if (c == '"' || c == '\\') in_quotes += '\\';
        in_quotes += c;
    }
    return in_quotes + '"';
}

/// Returns the names of the placeholders, such as "z" for "z:>7"; empty for a text without placeholders.
std::set<std::string> place_names(const std::string& text) {
    std::set<std::string> names;
    if (const Result<std::vector<std::string>> places = places_in(text))
        for (const std::string& place : *places) names.insert(place.substr(0, place.find(':')));
    return names;
}

/// Returns the meaning of a placeholder, or "" if places.h does not describe it.
std::string_view meaning_of(std::string_view name) {
    for (const auto& [known, meaning] : place_meanings)
        if (known == name) return meaning;
    return "";
}

int print_all(std::span<const char* const> sources) {
    Texts texts;
    for (const char* file : sources) {
        for (const PoEntry& entry : read(file)) add(texts, entry.english, {entry.where, ""});
    }
    add_tables(texts);
    std::cout << "msgid \"\"\nmsgstr \"Content-Type: text/plain; charset=UTF-8\\n\"\n";
    for (const auto& [english, origin] : texts) {
        std::cout << '\n';
        if (!origin.said.empty()) std::cout << "#. " << origin.said << '\n';
        const std::set<std::string> places = place_names(english);
        for (const std::string& place : places) std::cout << "#. {" << place << "}: " << meaning_of(place) << '\n';
        std::cout << "#: " << origin.files << '\n';
        // This flag makes msgfmt and Poedit compare the placeholders of a translation with those of the text.
        if (!places.empty()) std::cout << "#, python-brace-format\n";
        std::cout << "msgid " << quote(english) << "\nmsgstr \"\"\n";
    }
    return 0;
}

/// Returns the placeholders in alphabetical order, each with its format, since "{z:>7}" differs from "{z}". Returns
/// "none" if there are none, and the error message if braces do not match.
std::string places_text(const std::string& text) {
    const Result<std::vector<std::string>> places = places_in(text);
    if (!places) return places.error();
    std::string all;
    for (const std::string& place : *places) all += "{" + place + "}";
    return all.empty() ? "none" : all;
}

int check(const char* all, const char* catalogue) {
    std::set<std::string> english;
    for (const PoEntry& entry : read(all)) english.insert(entry.english);
    int wrong = 0;
    const auto complain = [&](const std::string& sentence) {
        std::cerr << catalogue << ": " << sentence << '\n';
        ++wrong;
    };
    for (const std::string& text : english)
        for (const std::string& place : place_names(text))
            if (meaning_of(place).empty()) complain("{" + place + "} has no line in tests/texts/places.h");
    std::set<std::string> listed;
    std::size_t untranslated = 0;
    for (const PoEntry& entry : read(catalogue)) {
        const std::string line = "line " + std::to_string(entry.line) + ": ";
        listed.insert(entry.english);
        if (!english.count(entry.english)) complain(line + "unused text " + quote(entry.english));
        if (entry.is_fuzzy || entry.translation.empty()) {
            ++untranslated;
            continue;
        }
        const std::string wanted = places_text(entry.english), has = places_text(entry.translation);
        if (has != wanted) complain(line + "the placeholders are " + has + " instead of " + wanted);
    }
    for (const std::string& text : english) {
        if (!listed.count(text)) complain("there is no entry for " + quote(text));
    }
    if (wrong > 0) {
        std::cerr << "`tests/catalogue --update` adds missing texts and removes unused ones\n";
        return 1;
    }
    std::cout << catalogue << ": " << english.size() << " texts, " << untranslated << " still English\n";
    return 0;
}

}  // namespace
}  // namespace viewing

int main(int count, char** arguments) {
    const std::string_view first = count > 1 ? arguments[1] : "";
    if (count == 4 && first == "--check") return viewing::check(arguments[2], arguments[3]);
    if (count > 1) return viewing::print_all({arguments + 1, arguments + count});
    std::cerr << "texts SOURCES.pot… | texts --check ALL.pot CATALOGUE.po\n";
    return 2;
}
