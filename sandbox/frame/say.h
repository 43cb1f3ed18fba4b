// How problems are said. Part of problems.h.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "frame/problems.h"
#include "text/catalogue.h"

namespace viewing {

/// Adds sentences to one group.
class Sayer {
public:
    Sayer(std::vector<Problem>& problems, std::string_view group) : problems_(problems), group_(group) {}

    /// Something to know.
    void operator()(bool is_so, std::string sentence) {
        if (is_so) problems_.push_back({std::move(sentence), group_});
    }
    /// A switch breaks the picture: why it looks as it does, and the field whose default mends it, or, where that does
    /// not, the setting that does; "" if it is not one.
    void broken(bool is_so, std::string sentence, std::string_view mended_by = "");

private:
    std::vector<Problem>& problems_;
    std::string_view group_;
};

// Lights and planes in a sentence, counted from 0 here and from 1 there; `count` is how many there are.

/// "the light", "light 2".
std::string light_name(std::size_t light, std::size_t count);
/// "the plane", "plane 2", "planes 2, 3".
std::string planes_name(std::span<const std::size_t> planes, std::size_t count);
/// "2, 3".
std::string numbers_name(std::span<const std::size_t> indices);

}  // namespace viewing
