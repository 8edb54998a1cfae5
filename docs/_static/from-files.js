// Browsers read no other page of a folder: the results of the search are shown without lines of their pages.
if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
