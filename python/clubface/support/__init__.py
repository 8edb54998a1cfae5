"""What every room uses and that knows nothing of golf: files of settings, checks, memory, resuming."""
