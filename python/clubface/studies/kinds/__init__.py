"""What studies compute: the interface of a kind, and a module for each."""
