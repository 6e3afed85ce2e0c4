# says: ModuleNotFoundError: No module named 'nothere'
import nothere
