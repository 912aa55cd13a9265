# SPDX-License-Identifier: BSD-3-Clause
# Writes page_files.cc: the files of a page as arrays of bytes, for the library experiments/<LIBRARY>.
#   cmake -DLIBRARY=<name> -DFOLDER=<page> -DFILES=<name>,<name>,... -DOUTPUT=<cc> -P embed_page.cmake
set(arrays "")
set(entries "")
set(count 0)
string(REPLACE "," ";" FILES "${FILES}")
foreach(name IN LISTS FILES)
  file(READ ${FOLDER}/${name} hex HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  string(APPEND arrays "const unsigned char kFile${count}[] = {${bytes}};\n")
  set(path "/${name}")
  if(name STREQUAL "index.html")
    set(path "/")
    set(type "text/html; charset=utf-8")
  elseif(name MATCHES "\\.js$")
    set(type "text/javascript; charset=utf-8")
  elseif(name MATCHES "\\.css$")
    set(type "text/css; charset=utf-8")
  elseif(name MATCHES "\\.svg$")
    set(type "image/svg+xml")
  else()
    message(FATAL_ERROR "${name}: expected a file of html, js, css or svg")
  endif()
  string(APPEND entries "      {\"${path}\", \"${type}\", Text(kFile${count})},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUTPUT} "// Made by embed_page.cmake.
#include \"experiments/${LIBRARY}/page_files.h\"

#include <cstddef>

namespace gmapping_spa::${LIBRARY} {
namespace {

${arrays}
template <std::size_t kSize>
std::string_view Text(const unsigned char (&bytes)[kSize]) {
  return {reinterpret_cast<const char*>(bytes), kSize};
}

}  // namespace

std::vector<view::StaticFile> PageFiles() {
  return {
${entries}  };
}

}  // namespace gmapping_spa::${LIBRARY}
")
