// Closed sets that are declared once: a list is a macro that applies another macro to each of its names. The
// enumeration, its names, and the entries that say what differs between its values are generated from that list. See
// topic.h for one.
#pragma once

#define VIEWING_ENUMERATOR(name) name,
#define VIEWING_NAME(name) #name,
#define VIEWING_NOTHING(name)
/// Declares an entry, inside a namespace with a type Entry; each is defined in the source that it is about.
#define VIEWING_ENTRY(name) extern const Entry name;
/// For a list of all entries, inside that namespace.
#define VIEWING_ADDRESS(name) &(name),
