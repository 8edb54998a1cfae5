"""Long work in parts: locks, stores of what is finished, and resumption after an interruption."""
