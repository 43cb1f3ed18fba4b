// Runs the program in a browser's page. The JavaScript side, page/page.js, supplies events, time and sizes, does
// everything that only JavaScript can do, and calls the functions in page.cpp.
#pragma once

namespace viewing {

/// Opens the sandbox on the page's canvas. From then on the page requests the frames.
void open_page();

}  // namespace viewing
