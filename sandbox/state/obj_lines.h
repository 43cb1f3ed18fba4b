// Internal to state/: the lines of an OBJ file that matter, checked before the library sees them. The library takes
// what is not a number for 0 and has no way to stop, so both are done here.
#pragma once

#include <istream>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "state/obj.h"

namespace viewing {

/// Passes on the "v", "vn" and "f" lines of a stream and drops all others; ends early at the first bad line, at a
/// cancelled job, or when stop() was called.
class ObjLines : public std::streambuf {
public:
    ObjLines(std::istream& source, std::uint64_t size_bytes, const ProgressSpan& progress)
        : source_(source), size_bytes_(size_bytes), progress_(progress) {}

    void stop() { stopped_ = true; }

    /// "" or what is wrong, with the line's number.
    const std::string& trouble() const { return trouble_; }

protected:
    int_type underflow() override;

private:
    void take_block();
    void take_line(std::string_view line);
    void refuse(std::string_view line, const std::string& what);

    std::istream& source_;
    std::uint64_t size_bytes_;
    ProgressSpan progress_;
    std::uint64_t bytes_read_ = 0;
    std::size_t line_number_ = 0;
    std::string unfinished_;  ///< the beginning of a line whose end is in the next block
    std::string passed_on_;
    std::string trouble_;
    bool stopped_ = false;
};

}  // namespace viewing
