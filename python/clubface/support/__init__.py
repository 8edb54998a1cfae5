"""Shared code that knows nothing about golf: files, checks, processes, sockets, deprecations."""
