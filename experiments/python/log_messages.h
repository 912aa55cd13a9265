// SPDX-License-Identifier: BSD-3-Clause
// Warnings of the library as messages of Python's logging.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_LOG_MESSAGES_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_LOG_MESSAGES_H_

namespace gmapping_spa::python {

// From now on what the library says through glog is kept, instead of going to stderr or to files.
// It comes from any thread, with locks held, so that it cannot be handed to Python at once.
void CollectLogMessages();

// Hands what was kept to the logger "gmapping_spa". Holds the GIL; to be called at the end of what
// may warn. May throw what a handler of the logger throws.
void HandOnLogMessages();

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_LOG_MESSAGES_H_
