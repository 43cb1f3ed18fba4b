// The program in a browser's page. The page's own side, page/page.js, brings events, time and sizes, and does what only
// a page can do; the functions that it calls are in page.cpp.
#pragma once

namespace viewing {

/// Opens the sandbox on the page's canvas. The page draws from then on.
void open_page();

}  // namespace viewing
