"""Building blocks of what the rooms show; engine side, no Qt."""
