// says: gave up
#include <iostream>
int main(){ std::cerr << "runtime error: none\nno Error\ngave up\n"; return 1; }
