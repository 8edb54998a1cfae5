"""The studio with Python behind it: the site, and on this machine alone what the site asks the package for.

It listens on 127.0.0.1. Nothing is answered without the random token of its address, to another host's name, or to a
page of another origin. The browser sends bytes of files and names of what the package ships, and never a path.
"""
