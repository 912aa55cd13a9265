# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, a source that tells which commit the folder SOURCE holds: "unknown" where it is no
# repository itself, as from a tarball. cmake -DSOURCE=... -DOUTPUT=... -P commit.cmake
cmake_path(GET SOURCE PARENT_PATH parent)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env GIT_CEILING_DIRECTORIES=${parent}
          git -C ${SOURCE} describe --always --dirty
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
file(WRITE ${OUTPUT} "namespace gmapping_spa::apps {
const char* LinkedCommit() { return \"${commit}\"; }
}  // namespace gmapping_spa::apps
")
