// Closed sets that are declared once: a list is a macro that applies another macro to each of its names. The
// enumeration, its names, and the entries that say what differs between its values are generated from that list. See
// topic.h for one.
#pragma once

#define VIEWING_ENUMERATOR(name) name,
#define VIEWING_NAME(name) #name,
#define VIEWING_NOTHING(name)
/// Declares the entry of a name, inside a namespace with a type Entry. The source about that name defines it.
#define VIEWING_ENTRY(name) extern const Entry name;
/// Gives the address of an entry, to list all entries inside the same namespace.
#define VIEWING_ADDRESS(name) &(name),
