# says: Bad: my own
class Bad(Exception): pass
e=Bad("my own"); 
try: e.add_note("a note")
except Exception: pass
import sys
print("debug: no Error here", file=sys.stderr)
raise e
