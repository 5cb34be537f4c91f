"""The language bias: what trees may test, its file with the mistakes in it, and the refinements that it spans."""
