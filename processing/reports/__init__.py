"""Reports as single HTML files with tables and charts, without scripts or network access."""
