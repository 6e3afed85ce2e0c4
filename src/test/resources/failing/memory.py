# says: MemoryError
import resource
resource.setrlimit(resource.RLIMIT_AS,(200<<20,200<<20))
x=[0]*(10**9)
