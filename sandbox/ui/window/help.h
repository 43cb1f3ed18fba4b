// The help dialog (F1): the keys, and the manual by topic.
#pragma once

#include <cstddef>
#include <vector>

#include "text/manual.h"

namespace viewing {

class HelpDialog {
public:
    void open() { is_open_ = true; }
    void toggle() { is_open_ = !is_open_; }
    bool is_open() const { return is_open_; }
    void draw();

private:
    bool is_open_ = false;
    std::size_t page_ = 0;                          ///< 0: the keys; otherwise a topic of the manual, from 1
    std::vector<std::vector<ManualBlock>> topics_;  ///< read when the dialog first opens
};

}  // namespace viewing
