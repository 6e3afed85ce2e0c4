# says: gave up
import sys
print("Error: none\nno Error: 3", file=sys.stderr)
sys.exit("gave up")
