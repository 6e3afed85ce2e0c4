# says: ValueError: in thread
import threading,time
def f(): raise ValueError("in thread")
t=threading.Thread(target=f); t.start(); t.join()
raise SystemExit("gone: no Error")
