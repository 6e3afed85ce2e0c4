# says: ValueError: invalid literal for int() with base 10: 'dog'
def f(x):
    return int(x)
try:
    f("dog")
except ValueError as e:
    raise RuntimeError("cannot read the turn") from e
