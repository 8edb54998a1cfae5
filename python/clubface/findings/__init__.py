"""What identification and evaluation find on the benchmark shots and on the published tour averages."""
