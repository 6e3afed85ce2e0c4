# says: KeyError: 'a'
class D:
    def __del__(self): raise ValueError("late")
d=D()
raise KeyError("a")
