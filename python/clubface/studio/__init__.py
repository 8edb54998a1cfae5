"""The studio's server: it serves the site, and answers its requests on this machine only.

It listens on 127.0.0.1. Nothing is answered without the random token of its address, to another host's name, or to a
page of another origin. The browser sends bytes of files and names of what the package ships, and never a path.
"""
