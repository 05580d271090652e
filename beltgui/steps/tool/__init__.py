"""Step 5, stylus and tool: the wheel of each grinder."""
