"""The report of a study: statistics, tables, plots, maps, and the page that holds them."""
