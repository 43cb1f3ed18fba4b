// Closed sets that are declared once: a list is a macro that applies another macro to each of its names, and the
// enumeration, its names and the declarations of its entries are generated from that list. See topic.h for one.
#pragma once

#define VIEWING_ENUMERATOR(name) name,
#define VIEWING_NAME(name) #name,
#define VIEWING_NOTHING(name)
