#!/usr/bin/sed -Ef
# Makes Doxygen read this project's comments: the first line of a header is about the file, a comment on
# a line of its own about what follows, one behind code about what it stands behind.
1s|^// |/// @file\n/// |
s|^( *)// |\1/// |
s|^( *)//$|\1///|
s|^( *[^/ ][^"]*[^/" ]) +// |\1 ///< |
