"""A face struck everywhere: maps of launch and flight, sweet spots and forgiveness."""
