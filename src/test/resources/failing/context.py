# says: NameError: name 'undefined_name' is not defined
try:
    {}["a"]
except KeyError:
    undefined_name
