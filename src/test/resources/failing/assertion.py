# says: AssertionError: one is two
assert 1 == 2, "one is two\nreally"
