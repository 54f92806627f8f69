"""Reports as single HTML files: page, tables and charts without scripts or anything from the network."""
