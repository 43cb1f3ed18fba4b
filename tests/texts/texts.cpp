// The texts that the window can show, for tests/catalogue.
//
//     texts SOURCES.pot…           what xgettext found in the sources, without what labels hide behind "##", and what
//     the
//                                  program itself lists: fields, presets and scenes. As one .pot file.
//     texts --check ALL.pot KO.po  whether the catalogue has all of them, nothing else, and the same places in each
//                                  translation as in the English text. 1, with a line for each that is wrong.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>

#include "state/fields.h"
#include "state/presets.h"
#include "text/po.h"

namespace viewing {
namespace {

/// English texts with where each comes from.
using Texts = std::map<std::string, std::string>;

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

/// Signs, symbols of formulas and names of axes have no word: two letters in a row.
bool has_word(std::string_view text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (is_letter(text[i - 1]) && is_letter(text[i])) return true;
    }
    return false;
}

void add(Texts& texts, std::string_view text, const std::string& where) {
    const std::string_view shown = text.substr(0, text.find("##"));
    if (has_word(shown)) texts.emplace(shown, where);
}

void add_tables(Texts& texts) {
    Params params;
    for (const Field& field : fields()) {
        const std::string where = "field " + std::string(field.path);
        for (const std::string_view text : {field.label, field.help, field.unit}) add(texts, text, where);
    }
    for (const auto& [files, kind] : {std::pair{presets(), "preset "}, std::pair{scenes(), "scene "}}) {
        for (const NamedFile& file : files) {
            for (const std::string& text : {file.title, file.about, file.group}) add(texts, text, kind + file.name);
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

int print_all(std::span<const char* const> sources) {
    Texts texts;
    for (const char* file : sources) {
        for (const PoEntry& entry : read(file)) add(texts, entry.english, "sources");
    }
    add_tables(texts);
    std::cout << "msgid \"\"\nmsgstr \"Content-Type: text/plain; charset=UTF-8\\n\"\n";
    for (const auto& [english, where] : texts) {
        std::cout << "\n#. " << where << "\nmsgid " << quote(english) << "\nmsgstr \"\"\n";
    }
    return 0;
}

/// In order of the alphabet, each with its format: "{z:>7}" is another place than "{z}". Empty with a message where
/// braces do not match.
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
    std::set<std::string> listed;
    for (const PoEntry& entry : read(catalogue)) {
        const std::string line = "line " + std::to_string(entry.line) + ": ";
        listed.insert(entry.english);
        if (!english.count(entry.english)) complain(line + "nobody shows " + quote(entry.english));
        if (entry.is_fuzzy || entry.translation.empty()) continue;
        const std::string wanted = places_text(entry.english), has = places_text(entry.translation);
        if (has != wanted) complain(line + "the places are " + has + " in place of " + wanted);
    }
    for (const std::string& text : english) {
        if (!listed.count(text)) complain("there is no entry for " + quote(text));
    }
    if (wrong > 0) {
        std::cerr << "`tests/catalogue --update` puts in what is missing and takes out what nobody shows\n";
        return 1;
    }
    std::cout << "catalogue: " << english.size() << " texts\n";
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
