# says: Fatal Python error: Segmentation fault
import ctypes,faulthandler
faulthandler.enable()
ctypes.string_at(0)
