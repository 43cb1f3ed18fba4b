// Locates every control of the window: `ui-where WIDTH HEIGHT [page | EXERCISE]` prints "x y label" lines with the
// center of each control of the opening window, the exercise page, or an exercise. The window tests click there; the
// layout is the same with and without a window.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "ui/exercise_desk.h"

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4) {
        std::fprintf(stderr, "usage: ui-where WIDTH HEIGHT [page | EXERCISE]\n");
        return 2;
    }
    viewing::test::ExerciseSheetDesk desk({std::strtof(argv[1], nullptr), std::strtof(argv[2], nullptr)});
    if (argc == 4 && std::strcmp(argv[3], "page") == 0) {
        desk.workbench.exercises.open_page();
        desk.ui.frames(4);
    } else if (argc == 4) {
        desk.begin(argv[3]);
    }
    for (const widgets::RecordedItem& item : desk.recorded())
        std::printf("%.0f %.0f %s\n", (item.min.x + item.max.x) * 0.5F, (item.min.y + item.max.y) * 0.5F,
                    item.label.c_str());
}
