// Where every control of the opening window is: `ui-where WIDTH HEIGHT` prints "x y label" lines, the middle of each.
// The window test clicks there; the layout is the same with a window as without.
#include <cstdio>
#include <cstdlib>

#include "ui/desk.h"

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: ui-where WIDTH HEIGHT\n");
        return 2;
    }
    const viewing::test::Desk desk({std::strtof(argv[1], nullptr), std::strtof(argv[2], nullptr)});
    for (const widgets::RecordedItem& item : desk.recorded())
        std::printf("%.0f %.0f %s\n", (item.min.x + item.max.x) * 0.5F, (item.min.y + item.max.y) * 0.5F,
                    item.label.c_str());
}
