# SPDX-License-Identifier: BSD-3-Clause
"""The report of a study: statistics, tables, plots, maps, and the page that holds them."""
