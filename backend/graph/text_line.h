// What all readers of text files do with a line.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_TEXT_LINE_H_
#define GMAPPING_SPA_BACKEND_GRAPH_TEXT_LINE_H_

#include <string>
#include <string_view>

namespace gmapping_spa::backend {

// The line without the UTF-8 byte order mark that some editors put in front of a file. For the
// first line of a file only.
std::string_view WithoutByteOrderMark(std::string_view line);

// The line up to its first '#'.
std::string_view WithoutComment(std::string_view line);

// Takes the next word off the front of `rest`, and the blanks before it; empty at the end.
std::string_view TakeWord(std::string_view* rest);

// The word as it can stand in a message of one line, even when the file is a binary one.
std::string Quoted(std::string_view word);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_TEXT_LINE_H_
