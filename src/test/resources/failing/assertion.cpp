// says: Assertion `x==2 && "x is two"' failed.
#include <cassert>
int main(){ int x=1; assert(x==2 && "x is two"); }
