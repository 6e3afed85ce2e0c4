// says: SyntaxError: The requested module 'fs' does not provide an export named 'nothing'
import { nothing } from 'fs';
