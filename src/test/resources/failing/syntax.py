# says: SyntaxError: invalid syntax
x = 3
def f(:
    pass
