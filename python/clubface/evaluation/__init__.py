"""How well models predict measured shots: errors beside published ones, where they come from, which model is best."""
