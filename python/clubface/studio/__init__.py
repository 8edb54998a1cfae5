"""The server of the studio: serves the site and its API on this machine only.

It listens on 127.0.0.1. Requests without the random token of its address, with another host name, or from another
origin are refused. The browser sends contents of files and names of built-in data, never a path.
"""
