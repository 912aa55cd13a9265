#!/usr/bin/sed -Ef
# Makes Doxygen read this project's comments: the first one of a header, behind its licence, is about the file,
# a comment on a line of its own about what follows, one behind code about what it stands behind.
1s|^// SPDX-.*|/// @file|
s|^( *)// |\1/// |
s|^( *)//$|\1///|
s|^( *[^/ ][^"]*[^/" ]) +// |\1 ///< |
